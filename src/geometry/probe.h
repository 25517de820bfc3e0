// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "geometry/triangle_tree.h"

#include <span>

namespace kushi {

/// A place, what of a closed surface is nearest to it, and whether it is inside.
struct Probe {
    Vec3f place;
    Nearest nearest;
    bool inside = false;
};

/// Probes a place. `nearby` are probes of other places, the nearest last: they make it quicker,
/// most of all where no surface fits in between, so that the side is theirs.
Probe probeAt(const TriangleTree& tree, Vec3f place, std::span<const Probe> nearby);

}  // namespace kushi
