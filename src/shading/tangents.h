// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <kushi/vec.h>

#include <cstddef>
#include <span>

namespace kushi {

/// Unit direction from `a` to `b`; zero where there is none (equal or not finite).
inline Vec3f directionBetween(Vec3f a, Vec3f b) {
    const Vec3f step = b - a;
    const float size = length(step);
    return size > 0 && std::isfinite(size) ? step / size : Vec3f{};
}

/// Calls visit(i, t) for every node with the mean direction t of the nearest segments before and
/// after it that have a length; at the ends, of the one that exists. Where a strand folds back on
/// itself t is along the fold, and zero in a strand without any length.
template <class Visit>
void forEachTangent(std::span<const Vec3f> nodes, Visit&& visit) {
    Vec3f before;
    Vec3f after;
    std::size_t searched = 0;  // `after` belongs to segment searched - 1
    for (std::size_t i = 0; i < nodes.size(); ++i) {
        if (i >= searched) {
            before = after;
            after = {};
            for (searched = i; searched + 1 < nodes.size() && after == Vec3f{}; ++searched) {
                after = directionBetween(nodes[searched], nodes[searched + 1]);
            }
            if (after == Vec3f{}) searched = nodes.size();
        }
        const Vec3f sum = before + after;
        const float size = length(sum);
        visit(i, size > 1e-6F ? sum / size : before);
    }
}

}  // namespace kushi
