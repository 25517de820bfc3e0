// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "head/polygonise.h"

#include <vector>

namespace kushi {

/// Replaces edges that run across a crease by the other diagonal of their two triangles where that
/// runs along it, so that lips and lids get clean outlines. `normals`: unit, one per point.
void flipAcrossCreases(const std::vector<Vec3d>& normals, HalfSurface& half);

}  // namespace kushi
