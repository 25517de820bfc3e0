// SPDX-License-Identifier: Apache-2.0
#include "pipeline/penetration.h"

#include <algorithm>

namespace kushi {

double deepestPoint(const Ellipsoid& ellipsoid, std::span<const Vec3f> nodes) {
    constexpr int pointsPerSegment = 8;
    double deepest = ellipsoid.depth(nodes.back().as<double>());
    for (std::size_t i = 1; i < nodes.size(); ++i) {
        const Vec3d from = nodes[i - 1].as<double>();
        const Vec3d step = (nodes[i].as<double>() - from) / double{pointsPerSegment};
        for (int k = 0; k < pointsPerSegment; ++k) {
            deepest = std::max(deepest, ellipsoid.depth(from + double(k) * step));
        }
    }
    return deepest;
}

}  // namespace kushi
