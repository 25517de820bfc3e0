// SPDX-License-Identifier: Apache-2.0
#include "pipeline/penetration.h"

#include <algorithm>

namespace kushi {

namespace {

double depth(const Obstacles& obstacles, Vec3d place) {
    double deepest = 0;
    if (obstacles.ellipsoid != nullptr) deepest = obstacles.ellipsoid->depth(place);
    if (obstacles.solids == nullptr) return deepest;
    return std::max(deepest, -double{distanceAt(*obstacles.solids, place.as<float>())});
}

}  // namespace

double deepestPoint(const Obstacles& obstacles, std::span<const Vec3f> nodes) {
    constexpr int pointsPerSegment = 8;
    double deepest = depth(obstacles, nodes.back().as<double>());
    for (std::size_t i = 1; i < nodes.size(); ++i) {
        const Vec3d from = nodes[i - 1].as<double>();
        const Vec3d step = (nodes[i].as<double>() - from) / double{pointsPerSegment};
        for (int k = 0; k < pointsPerSegment; ++k)
            deepest = std::max(deepest, depth(obstacles, from + double(k) * step));
    }
    return deepest;
}

}  // namespace kushi
