// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "contact/obstacles.h"

namespace kushi {

/// Turns the segment from -> to, whose end lies inside an obstacle, until its end lies outside
/// (Usami & Anjyo 1992, 2.3, figure 6).
///
/// Within the plane of `before`, `from` and `to` (where these are in line: the plane of the segment
/// and the outward normal) both sides are tried at 90, 45, 22.5, ... degrees from the segment's
/// direction, `steps` angles in all; a side goes on while its end stays outside. The smallest angle
/// of the side that lasts longest wins, at equal length the one nearer to the direction
/// before -> from. An ellipsoid is convex, so that one side is outside at 90 degrees whenever
/// `from` is; where solids leave neither, the segment turns along the outward normal.
///
/// before  the node before `from`, or a point behind the root
/// steps   > 0
/// returns the segment's new end, as far from `from` as `to` was
Vec3d avoid(const Obstacles& obstacles, Vec3d before, Vec3d from, Vec3d to, int steps);

}  // namespace kushi
