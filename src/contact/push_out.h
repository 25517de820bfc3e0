// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <kushi/distance_field.h>

#include <span>

namespace kushi {

/// How far a strand is from solids at the place where it is nearest for its way from the root [m]:
/// a root may lie on a surface, or in it, and the strand must have come out by a third of the way
/// it has gone.
///
/// nodes   root first [m], at least one
/// margin  how far off the strand is wanted, >= 0 [m]; places that are farther do not count
double clearance(const DistanceField& solids, std::span<const Vec3f> nodes, double margin);

/// Turns segments, from the root outwards, until no place of a strand is nearer to solids than
/// `margin`, but for what its root needs to come out of them, as clearance() has it. A segment
/// turns about its beginning, by little where little is enough; what lies beyond goes with it and
/// keeps its direction. Straight into a face there is no such way: it goes on along the face as the
/// segment before it, or down. Lengths stay. Whether that is done; if not, the strand lies better
/// than it did, but not free.
bool pushOut(const DistanceField& solids, double margin, std::span<Vec3f> nodes);

}  // namespace kushi
