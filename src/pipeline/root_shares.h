// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "style/ranges.h"

#include <vector>

namespace kushi {

/// How much of each force strands get that grow at these places, strand by strand.
inline std::vector<float> rootShares(std::span<const Force> forces,
                                     std::span<const EllipsoidAngles> roots) {
    std::vector<float> shares;
    for (const EllipsoidAngles& root : roots) {
        for (const Force& force : forces)
            shares.push_back(static_cast<float>(share(force.roots, root, force.falloff.angle)));
    }
    return shares;
}

/// The values of some strands.
template <class T>
std::vector<T> picked(const std::vector<T>& values, std::span<const std::uint32_t> which) {
    std::vector<T> some;
    for (const std::uint32_t i : which)
        some.push_back(values[i]);
    return some;
}

}  // namespace kushi
