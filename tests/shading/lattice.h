// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <kushi/strands.h>

#include <cmath>

namespace kushi::test {

/// Upright strands on a square lattice, `side` x `side` of them about the y axis, each begun a
/// little lower than at 0, as no hair has its nodes in layers.
///
/// pitch, height, diameter  m
inline Strands lattice(int side, float pitch, float height, float diameter, int segments = 20) {
    Strands strands;
    const float first = -0.5F * static_cast<float>(side - 1) * pitch;
    for (int i = 0; i < side; ++i) {
        for (int j = 0; j < side; ++j) {
            std::vector<Vec3f> nodes;
            const float turn = 0.618034F * static_cast<float>(i * side + j);
            const float lower = (turn - std::floor(turn)) * height / static_cast<float>(segments);
            for (int k = 0; k <= segments; ++k) {
                const float share = static_cast<float>(k) / static_cast<float>(segments);
                nodes.push_back({first + static_cast<float>(i) * pitch, share * height - lower,
                                 first + static_cast<float>(j) * pitch});
            }
            strands.add(nodes, static_cast<std::uint64_t>(i * side + j));
        }
    }
    strands.diameters.assign(strands.nodes.size(), diameter);
    return strands;
}

}  // namespace kushi::test
