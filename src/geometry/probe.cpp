// SPDX-License-Identifier: Apache-2.0
#include "geometry/probe.h"

namespace kushi {
namespace {

/// Whether no surface can lie between two places: each would be nearer to it than it is.
bool surelySameSide(const Probe& a, const Probe& b) {
    constexpr float rounding = 1.0001F;
    return a.nearest.distance + b.nearest.distance > rounding * length(a.place - b.place);
}

}  // namespace

Probe probeAt(const TriangleTree& tree, Vec3f place, std::span<const Probe> nearby) {
    const std::uint32_t guess = nearby.empty() ? 0 : nearby.back().nearest.triangle;
    Probe probe = {place, nearestIn(tree, place, guess), false};
    for (const Probe& other : nearby) {
        if (surelySameSide(probe, other)) {
            probe.inside = other.inside;
            return probe;
        }
    }
    probe.inside = windingNumber(tree, place) > 0.5;
    return probe;
}

}  // namespace kushi
