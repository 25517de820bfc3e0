// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "contact/route.h"

#include <kushi/rods.h>

#include <optional>
#include <vector>

namespace kushi {

/// The way of a strand to the tie that holds it.
struct WayToTie {
    Route route;
    double walked = 0;  ///< along the strand [m]: the route's length and the slack
};

/// Of the first of the part's ties that a follicle's root range meets; none if no tie does, or if a
/// strand of that length does not reach it.
///
/// angles, key  of the follicle
/// length       of its strand [m]
std::optional<WayToTie> wayToTie(const Part& part, Vec3d root, EllipsoidAngles angles,
                                 std::uint64_t key, double length);

/// Lays strands along their ways, from where they hang on: their `starts`, which must be empty, and
/// the tie of each.
///
/// ways     of each of the rods
/// gravity  times the earth's
std::vector<Tie> layAlong(std::span<const WayToTie> ways, Vec3d gravity, Rods& rods);

}  // namespace kushi
