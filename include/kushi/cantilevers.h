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
/// A strand is within 1e-4 of its length of what bendCantilever() gives, and mostly within 1e-6,
/// but for a few in ten thousand of which a segment's end lies at the very surface of the obstacle,
/// so that it is turned by another angle (docs/physics.md). No node is inside by isInside()'s
/// measure.
///
/// rods   straight, of equal segments: natural curvature, thickness and the like do not count
/// world  forces act as loadAt() has it
/// nodes  rods.nodeCount() of them; overwritten [m]
///
/// Results do not depend on the number of threads, nor on the processor, nor does a strand's on the
/// others.
void bendCantilevers(const Rods& rods, const RodWorld& world, std::span<Vec3f> nodes,
                     const WalkOptions& options = {});

}  // namespace kushi
