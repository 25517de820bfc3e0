// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <kushi/rods.h>

namespace kushi {

struct WalkOptions {
    int avoidanceSteps = 4;  ///< angles tried where a segment would run into the obstacle, > 0
    int threads = 0;         ///< 0: as many as the machine has
};

/// Bends many strands as bendCantilever() does one (Usami & Anjyo 1992, 2.2 and 2.3), side by side
/// and in single precision.
///
/// They are within 1e-4 of their lengths of what it gives, but for a few in a thousand that decide
/// otherwise on the side or the angle of avoidance or at a force's hard edge, and for hair so heavy
/// (w L^3 / EI beyond 8 n for n segments) that the walk itself overshoots and grows any difference.
/// No node comes to lie inside the obstacle by more than isInside()'s 1e-6.
///
/// rods   straight, of equal segments: natural curvature, thickness and the like do not count
/// world  forces act as loadAt() has it
/// nodes  rods.nodeCount() of them; overwritten [m]
/// The same bytes from any processor of one kind and any number of threads.
void bendCantilevers(const Rods& rods, const RodWorld& world, std::span<Vec3f> nodes,
                     const WalkOptions& options = {});

}  // namespace kushi
