// SPDX-License-Identifier: Apache-2.0
#include "head/edges.h"

#include <algorithm>
#include <tuple>

namespace kushi {

Edges::Edges(const std::vector<Triangle>& triangles) : ofTriangle_(triangles.size()) {
    struct Side {
        std::uint32_t a, b, triangle, corner;
    };
    std::vector<Side> sides;
    sides.reserve(3 * triangles.size());
    for (std::uint32_t t = 0; t < triangles.size(); ++t) {
        for (std::uint32_t c = 0; c < 3; ++c) {
            const auto [a, b] = std::minmax(triangles[t][c], triangles[t][(c + 1) % 3]);
            sides.push_back({a, b, t, c});
        }
    }
    std::ranges::sort(sides, [](const Side& s, const Side& t) {
        return std::tie(s.a, s.b, s.triangle) < std::tie(t.a, t.b, t.triangle);
    });
    for (const Side& side : sides) {
        const std::pair ends = {side.a, side.b};
        if (ends_.empty() || ends_.back() != ends) ends_.push_back(ends);
        ofTriangle_[side.triangle][side.corner] = static_cast<std::uint32_t>(ends_.size() - 1);
    }
}

bool Edges::contains(std::uint32_t a, std::uint32_t b) const {
    return std::ranges::binary_search(ends_, Ends{std::min(a, b), std::max(a, b)});
}

}  // namespace kushi
