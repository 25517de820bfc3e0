// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <kushi/distance_field.h>
#include <kushi/strands.h>

#include <cstddef>

namespace kushi {

/// How far strands are inside of solids.
struct Penetration {
    double deepest = 0;       ///< of 8 points a segment and the tip [m]
    std::size_t strands = 0;  ///< that are deeper than 0.1 mm
};

Penetration penetrationOf(const DistanceField& solids, const Strands& groom, int threads = 0);

struct PushOutReport {
    std::size_t pushed = 0;  ///< strands that were turned out of the solids
    std::size_t stuck = 0;   ///< of these, what still has a place in them or too near
};

/// Turns segments of a groom, from the roots outwards, until no place of a strand is in solids or
/// nearer than 0.3 of the field's spacing, 0.75 mm as a rule: by as little as it takes, so that a
/// strand that ends in a head lies around it, and what is beyond goes with it and keeps its
/// direction; one that runs straight into a face goes on along it, or down. Roots stay, and a
/// strand whose root lies in solids comes out of them at a slant. Lengths stay. The same nodes from
/// any number of threads.
PushOutReport pushOut(const DistanceField& solids, Strands& groom, int threads = 0);

}  // namespace kushi
