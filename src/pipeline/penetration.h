// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "contact/obstacles.h"

#include <kushi/push_out.h>

#include <algorithm>
#include <span>

namespace kushi {

/// Depth from which a strand counts as inside [m].
inline constexpr double insideFrom = 1e-4;

/// One strand more, whose deepest point lies so deep [m].
inline void include(double depth, Penetration& found) {
    found.deepest = std::max(found.deepest, depth);
    found.strands += depth > insideFrom ? 1 : 0;
}

/// Depth of the deepest point of a strand inside what it is kept out of [m], of 8 points on each
/// segment (its first end and 7 more) and the tip; 0: it is outside.
double deepestPoint(const Obstacles& obstacles, std::span<const Vec3f> nodes);

}  // namespace kushi
