// SPDX-License-Identifier: Apache-2.0
#include "scalp/point_tree.h"

#include <kushi/follicles.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>
#include <queue>
#include <tuple>

namespace kushi {

namespace {

// Pairs (index among the members, squared distance), nearest first, ties by index.
std::vector<std::pair<std::size_t, double>> neighbours(const PointTree& tree, Vec3d at,
                                                       double radius) {
    const std::array<double, 3> query = {at.x, at.y, at.z};
    std::vector<std::pair<std::size_t, double>> found;
    tree.radiusSearch(query.data(), radius * radius, found, nanoflann::SearchParams(0, 0, false));
    std::sort(found.begin(), found.end());
    return found;
}

// Takes members out, always the one with the most crowded surroundings, until `target` are left.
// The order in which they go depends on `scale` (the number that the whole round aims at), not on
// `target`; so rounds that stop early keep a superset.
std::vector<std::size_t> eliminate(const Follicles& follicles,
                                   const std::vector<std::size_t>& members, double area,
                                   std::size_t scale, std::size_t target) {
    std::vector<Vec3d> roots;
    roots.reserve(members.size());
    for (const std::size_t member : members)
        roots.push_back(follicles.roots[member]);
    const PointCloud cloud{roots};
    const PointTree tree(3, cloud, nanoflann::KDTreeSingleIndexAdaptorParams(16));
    const double reach =
        2 * std::sqrt(area / (2 * std::numbers::sqrt3 * static_cast<double>(scale)));
    const auto crowding = [reach](double squaredDistance) {
        const double nearness = std::max(0.0, 1 - std::sqrt(squaredDistance) / reach);
        return std::pow(nearness, 8);
    };

    // By mask or edge hair is sparser, and neighbours farther apart. Of two the denser place
    // counts, so that each is as near to the other.
    constexpr float leastShare = 0.04F;
    const auto shareOf = [&](std::size_t i) {
        return follicles.shares.empty() ? 1.0 : std::max(leastShare, follicles.shares[members[i]]);
    };
    const auto around = [&](std::size_t i) {
        return neighbours(tree, roots[i], reach / std::sqrt(shareOf(i)));
    };
    const auto between = [&](std::size_t i, std::size_t j, double squaredDistance) {
        return crowding(std::max(shareOf(i), shareOf(j)) * squaredDistance);
    };

    std::vector<double> weights(members.size(), 0);
    for (std::size_t i = 0; i < members.size(); ++i) {
        for (const auto& [j, squared] : around(i)) {
            if (j != i) weights[i] += between(i, j, squared);
        }
    }

    // Weights only fall, so an entry that is out of date is re-entered when it comes up.
    using Entry = std::tuple<double, std::uint64_t, std::size_t>;
    std::priority_queue<Entry> queue;
    const auto enter = [&](std::size_t i) {
        queue.emplace(weights[i], follicles.keys[members[i]], i);
    };
    for (std::size_t i = 0; i < members.size(); ++i)
        enter(i);

    std::vector<bool> gone(members.size(), false);
    for (std::size_t left = members.size(); left > target;) {
        const auto [weight, key, i] = queue.top();
        queue.pop();
        if (weight != weights[i]) {
            enter(i);
            continue;
        }
        gone[i] = true;
        --left;
        for (const auto& [j, squared] : around(i)) {
            if (!gone[j]) weights[j] -= between(i, j, squared);
        }
    }

    std::vector<std::size_t> kept;
    for (std::size_t i = 0; i < members.size(); ++i) {
        if (!gone[i]) kept.push_back(members[i]);
    }
    return kept;
}

}  // namespace

Follicles thin(const Follicles& follicles, std::size_t count) {
    if (count >= follicles.size()) return follicles;
    const double area =
        follicles.spacing * follicles.spacing * static_cast<double>(follicles.size());

    std::vector<std::size_t> members(follicles.size());
    for (std::size_t i = 0; i < members.size(); ++i)
        members[i] = i;
    while (members.size() > count) {
        const std::size_t half = std::max<std::size_t>(1, members.size() / 2);
        members = eliminate(follicles, members, area, half, std::max(count, half));
        if (members.size() == 1) break;
    }
    if (count == 0) members.clear();

    Follicles kept;
    kept.spacing = count > 0 ? std::sqrt(area / static_cast<double>(count)) : 0;
    for (const std::size_t i : members) {
        kept.roots.push_back(follicles.roots[i]);
        kept.normals.push_back(follicles.normals[i]);
        kept.angles.push_back(follicles.angles[i]);
        if (!follicles.shares.empty()) kept.shares.push_back(follicles.shares[i]);
        kept.keys.push_back(follicles.keys[i]);
    }
    return kept;
}

}  // namespace kushi
