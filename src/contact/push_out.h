// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <kushi/distance_field.h>

#include <span>

namespace kushi {

/// How a strand lies.
enum class Pushed {
    No,     ///< it was free
    Out,    ///< it has been turned until it was
    Stuck,  ///< it lies better than it did, but not free
};

/// Turns segments, from the root outwards, until no place of a strand is nearer to solids than
/// `margin`. A root may lie on a surface, or in it: there the strand must have come out by a third
/// of the way it has gone. A segment turns about its beginning, by little where little is enough;
/// what lies beyond goes with it and keeps its direction. Straight into a face there is no such
/// way: it goes on along the face as the segment before it, or down. Lengths stay.
///
/// margin  >= 0 [m]
/// nodes   root first [m], at least one
Pushed pushOut(const DistanceField& solids, double margin, std::span<Vec3f> nodes);

}  // namespace kushi
