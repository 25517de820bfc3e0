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

/// The mean of two unit directions, either of which may be zero; along the first where they are
/// opposite.
inline Vec3f meanDirection(Vec3f before, Vec3f after) {
    const Vec3f sum = before + after;
    const float size = length(sum);
    return size > 1e-6F ? sum / size : before;
}

/// The direction of a strand at node i: the mean of those of the nearest segments before and after
/// it that have a length, looked for among 32; at the ends, that of the one that exists. Where a
/// strand folds back on itself it is along the fold, and zero where there is no length.
inline Vec3f tangentAt(std::span<const Vec3f> nodes, std::size_t i) {
    constexpr std::size_t farthest = 32;
    Vec3f before;
    Vec3f after;
    for (std::size_t j = i; j > 0 && i - j < farthest && before == Vec3f{}; --j)
        before = directionBetween(nodes[j - 1], nodes[j]);
    for (std::size_t j = i; j + 1 < nodes.size() && j - i < farthest && after == Vec3f{}; ++j)
        after = directionBetween(nodes[j], nodes[j + 1]);
    return meanDirection(before, after);
}

/// Calls visit(i, t) for every node i with the strand's direction t there, as above, however far
/// the next segment with a length.
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
        visit(i, meanDirection(before, after));
    }
}

}  // namespace kushi
