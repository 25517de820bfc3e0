// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "shading/hair_grid.h"

namespace kushi {

/// For each cube, how many fibres light from far away crosses before it comes to the cube's centre.
///
/// Goes through the grid a layer of cubes at a time, from the light on: what is crossed up to a cube
/// is what is crossed up to the place in the layer before where its light comes from, between four
/// cubes, and the way from there. So shadows get softer with depth, as those of a lamp with a size.
///
/// towardsLight  unit
std::vector<float> crossingsTowards(const HairGrid& grid, Vec3f towardsLight);

}  // namespace kushi
