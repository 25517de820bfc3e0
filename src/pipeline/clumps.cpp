// SPDX-License-Identifier: Apache-2.0
#include "pipeline/clumps.h"

#include "core/random.h"

#include <algorithm>
#include <cmath>
#include <numeric>
#include <tuple>

namespace kushi {

namespace {

constexpr std::uint64_t orderSalt = 0x6f72646572;
// Discs put down at random until none fits cover 0.547 of a plane, so that as many centres come as
// squares of the size would have.
constexpr double leastDistance = 0.83;

std::uint64_t cellKey(std::int64_t x, std::int64_t y, std::int64_t z) {
    std::uint64_t key = 0;
    for (const std::int64_t number : {x, y, z})
        key = mixKey(key, static_cast<std::uint64_t>(number));
    return key;
}

std::int64_t cellAlong(double at, double edge) {
    return static_cast<std::int64_t>(std::floor(at / edge));
}

// The 27 cells of a grid about a place, its own in the middle.
template <class Visit>
void eachCellAround(Vec3d place, double edge, Visit visit) {
    const std::int64_t column = cellAlong(place.x, edge);
    const std::int64_t row = cellAlong(place.y, edge);
    const std::int64_t layer = cellAlong(place.z, edge);
    for (std::int64_t x = column - 1; x <= column + 1; ++x)
        for (std::int64_t y = row - 1; y <= row + 1; ++y)
            for (std::int64_t z = layer - 1; z <= layer + 1; ++z)
                visit(cellKey(x, y, z));
}

std::uint64_t cellOf(Vec3d place, double edge) {
    return cellKey(cellAlong(place.x, edge), cellAlong(place.y, edge), cellAlong(place.z, edge));
}

}  // namespace

ClumpCentres::ClumpCentres(std::span<const Vec3d> roots, std::span<const std::uint64_t> keys,
                           double size)
    : apart_(leastDistance * size) {
    std::vector<std::uint32_t> order(roots.size());
    std::iota(order.begin(), order.end(), 0U);
    const auto lot = [&](std::uint32_t i) {
        return std::tuple(mixKey(keys[i], orderSalt), roots[i].x, roots[i].y, roots[i].z);
    };
    std::ranges::sort(order, {}, lot);
    for (const std::uint32_t i : order) {
        if (!farFromAll(roots[i])) continue;
        cells_[cellOf(roots[i], 2 * apart_)].push_back(static_cast<std::uint32_t>(points_.size()));
        points_.push_back(roots[i]);
        keys_.push_back(keys[i]);
    }
}

bool ClumpCentres::farFromAll(Vec3d place) const {
    return std::ranges::all_of(
        around(place), [&](std::uint32_t i) { return length(points_[i] - place) >= apart_; });
}

std::vector<std::uint32_t> ClumpCentres::around(Vec3d place) const {
    std::vector<std::uint32_t> found;
    eachCellAround(place, 2 * apart_, [&](std::uint64_t key) {
        const auto cell = cells_.find(key);
        if (cell == cells_.end()) return;
        found.insert(found.end(), cell->second.begin(), cell->second.end());
    });
    std::ranges::sort(found);
    return found;
}

}  // namespace kushi
