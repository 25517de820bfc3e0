// SPDX-License-Identifier: Apache-2.0
#include "geometry/probe.h"

namespace kushi {

Probe probeOf(const TriangleTree& tree, Vec3f place, float distance,
              std::span<const Probe> nearby) {
    for (const Probe& other : nearby) {
        // A surface in between would be nearer to one of them than its distance.
        constexpr float rounding = 1.0001F;
        if (distance + other.distance > rounding * length(place - other.place)) {
            return {place, distance, other.inside};
        }
    }
    return {place, distance, windingNumber(tree, place.as<double>()) > 0.5};
}

}  // namespace kushi
