// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "geometry/pieces.h"
#include "geometry/triangle.h"

#include <span>
#include <vector>

namespace kushi {

/// What closes triangles: a fan around the middle of each connected piece of their border. The
/// border has each side as often as it runs one way more often than the other, so that it consists
/// of closed loops whatever the triangles are like.
std::vector<Triangle> capsOf(std::span<const Corners> triangles, std::span<const Vec3f> vertices);

}  // namespace kushi
