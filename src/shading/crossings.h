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
/// ahead         what is given is for the place this share of a cube nearer to the light, in [0, 1]:
///               hair does not lie in its own shadow
std::vector<float> crossingsTowards(const HairGrid& grid, Vec3f towardsLight, float ahead);

}  // namespace kushi
