// SPDX-License-Identifier: Apache-2.0
#include "geometry/caps.h"

#include <algorithm>
#include <cstdlib>
#include <numeric>
#include <utility>

namespace kushi {
namespace {

/// A side of the border, the way the triangles run along it.
using Side = std::pair<std::uint32_t, std::uint32_t>;

std::vector<Side> borderOf(std::span<const Corners> triangles) {
    struct Way {
        Side side;  ///< the lower vertex first
        int times;
    };
    std::vector<Way> ways;
    ways.reserve(3 * triangles.size());
    for (const Corners& corners : triangles) {
        for (std::size_t k = 0; k < 3; ++k) {
            const std::uint32_t from = corners[k], to = corners[(k + 1) % 3];
            ways.push_back({std::minmax({from, to}), from < to ? 1 : -1});
        }
    }
    std::ranges::sort(ways, {}, &Way::side);
    std::vector<Side> border;
    for (std::size_t i = 0; i < ways.size();) {
        const Side side = ways[i].side;
        int times = 0;
        for (; i < ways.size() && ways[i].side == side; ++i)
            times += ways[i].times;
        const Side along = times > 0 ? side : Side{side.second, side.first};
        border.insert(border.end(), static_cast<std::size_t>(std::abs(times)), along);
    }
    return border;
}

/// Which things are connected.
class Groups {
public:
    explicit Groups(std::size_t count) : parents_(count) {
        std::iota(parents_.begin(), parents_.end(), std::size_t{0});
    }
    std::size_t of(std::size_t i) {
        while (parents_[i] != i)
            i = parents_[i] = parents_[parents_[i]];
        return i;
    }
    void join(std::size_t a, std::size_t b) { parents_[of(a)] = of(b); }

private:
    std::vector<std::size_t> parents_;
};

}  // namespace

std::vector<Triangle> capsOf(std::span<const Corners> triangles, std::span<const Vec3f> vertices) {
    const std::vector<Side> border = borderOf(triangles);
    std::vector<std::uint32_t> used;
    for (const auto& [from, to] : border)
        used.insert(used.end(), {from, to});
    std::ranges::sort(used);
    used.erase(std::unique(used.begin(), used.end()), used.end());
    const auto place = [&used](std::uint32_t vertex) {
        return static_cast<std::size_t>(std::ranges::lower_bound(used, vertex) - used.begin());
    };

    Groups groups(used.size());
    for (const auto& [from, to] : border)
        groups.join(place(from), place(to));
    std::vector<Vec3d> middles(used.size());
    std::vector<double> counts(used.size());
    for (std::size_t i = 0; i < used.size(); ++i) {
        middles[groups.of(i)] += vertices[used[i]].as<double>();
        ++counts[groups.of(i)];
    }
    std::vector<Triangle> caps;
    for (const auto& [from, to] : border) {
        const std::size_t group = groups.of(place(from));
        const Vec3f middle = (middles[group] / counts[group]).as<float>();
        caps.push_back({vertices[to], vertices[from], middle});
    }
    return caps;
}

}  // namespace kushi
