// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "geometry/triangle_tree.h"

#include <span>

namespace kushi {

/// A place, how far it is from a closed surface, and whether it is inside.
struct Probe {
    Vec3f place;
    float distance = 0;  ///< never below 0
    bool inside = false;
};

/// Finds the side of a place, given its distance. Where no surface fits between it and one of the
/// probes nearby, it is theirs; else the winding number tells.
Probe probeOf(const TriangleTree& tree, Vec3f place, float distance, std::span<const Probe> nearby);

}  // namespace kushi
