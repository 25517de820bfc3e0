// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <kushi/rods.h>

#include <span>
#include <vector>

namespace kushi {

/// A unit quaternion: a rotation of a strand's axes into the world's.
struct Rotation {
    double w = 1;
    Vec3d v;
};

Rotation operator*(const Rotation& a, const Rotation& b);
Rotation inverse(const Rotation& a);
Rotation normalized(const Rotation& a);
/// The rotation halfway between.
Rotation halfway(const Rotation& a, const Rotation& b);
Vec3d rotate(const Rotation& by, Vec3d v);

/// The tangents of a polyline at its nodes: each of the circle through the node and its
/// neighbours, at the ends of that through the three last. No two in a row are more than
/// `sharpest` apart: at a sharper kink they fall behind.
///
/// nodes  two at least, no two in a row in the same place
std::vector<Vec3d> nodeTangents(std::span<const Vec3d> nodes);

/// Most that tangents turn over a segment [rad].
inline constexpr double sharpest = 1.5;

/// Frames with d3 along the tangents that do not twist from one to the next (parallel transport).
std::vector<Rotation> framesAlong(std::span<const Vec3d> tangents);
/// The same, from a given frame at the first of them.
std::vector<Rotation> framesAlong(std::span<const Vec3d> tangents, const Rotation& first);

Rotation rotationOf(const Frame& frame);
Frame frameOf(const Rotation& rotation);

}  // namespace kushi
