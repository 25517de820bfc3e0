// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "contact/obstacles.h"
#include "pipeline/clumps.h"

#include <kushi/style.h>

#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

namespace kushi {

/// A part's strands at rest.
struct StrandsAtRest {
    std::vector<std::span<Vec3f>> strands;  ///< root first [m]; empty where nothing is left of one
    std::span<const std::uint64_t> keys;    ///< of each
};

struct DressReport {
    std::size_t clumps = 0;    ///< that strands lie in
    std::size_t flyaways = 0;  ///< strands that were bent away
};

/// Whether there is anything to dress.
inline bool isDressed(const Hair& hair) {
    return hair.clump.amount > 0 || hair.flyaway.share > 0;
}

/// Draws strands together into clumps, and bends flyaways off, where they have come to rest: what
/// rest does not know, of oil, static and touch. Roots stay where they are and segments as long as
/// they are, but for flyaways, which become shorter; the same nodes from any number of threads.
///
/// A clump's guide is the strand that grows nearest to its centre. A strand belongs to that guide,
/// of those about its root, that it stays nearest to on its way, and at a share t of its length
/// goes by amount x S(t) of the way to it, where S is a smooth step from `from` to 1. It stays two
/// diameters off, and those that part from all guides by some sizes stay away. Whole clumps, with
/// their guides, stray in waves of 6 to 12 cm by amount x size / 2 at most, outwards and to both
/// sides.
///
/// obstacles  that strands stay out of; one that cannot, is dressed less, and in the end not at all
/// middle     of the head [m]
DressReport dress(const Hair& hair, const ClumpCentres& centres, Vec3d middle,
                  const Obstacles& obstacles, const StrandsAtRest& atRest, int threads);

}  // namespace kushi
