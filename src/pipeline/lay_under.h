// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <kushi/distance_field.h>
#include <kushi/ellipsoid.h>
#include <kushi/rods.h>

namespace kushi {

/// Whether something lies over a root within 4 cm, such as a hat: hair that grew through it would
/// be on both of its sides.
///
/// normal  of the head at the root, outwards
bool isCovered(const DistanceField& solids, Vec3d root, Vec3d normal);

/// Lays strands flat, as the hand does that puts on a hat: each goes over the head where it grows
/// to, down to where the head is widest, and hangs from there. Their `starts`, which must be empty.
///
/// gravity  times the earth's
void layUnder(const Ellipsoid& head, Vec3d gravity, Rods& rods);

}  // namespace kushi
