// SPDX-License-Identifier: Apache-2.0
#include <kushi/follicles.h>

#include <algorithm>
#include <cmath>
#include <set>

#include <gtest/gtest.h>

namespace kushi {
namespace {

Follicles planted() {
    Scalp s;
    s.ellipsoid = {{}, {0.105, 0.125, 0.085}, radians(20)};
    s.spacing = 0.004;
    s.regions = {{{0, radians(100)}, {}}};
    return *plant(s, 2);
}

std::vector<double> nearestDistances(const Follicles& follicles) {
    std::vector<double> nearest;
    for (std::size_t i = 0; i < follicles.size(); ++i) {
        double least = 1;
        for (std::size_t k = 0; k < follicles.size(); ++k) {
            if (k != i) least = std::min(least, length(follicles.roots[i] - follicles.roots[k]));
        }
        nearest.push_back(least);
    }
    return nearest;
}

TEST(Thin, KeepsASubsetInItsOrder) {
    const Follicles all = planted();
    const Follicles some = thin(all, 321);
    ASSERT_EQ(some.size(), 321U);
    std::size_t at = 0;
    for (std::size_t i = 0; i < some.size(); ++i) {
        while (at < all.size() && all.keys[at] != some.keys[i])
            ++at;
        ASSERT_LT(at, all.size());
        EXPECT_EQ(all.roots[at], some.roots[i]);
    }
}

TEST(Thin, WhatASmallerCountKeepsALargerOneKeepsToo) {
    const Follicles all = planted();
    std::set<std::uint64_t> last;
    for (const std::size_t count :
         {1UL, 2UL, 10UL, 77UL, 300UL, 301UL, 1000UL, all.size() / 2, all.size() - 1}) {
        const Follicles some = thin(all, count);
        ASSERT_EQ(some.size(), count);
        const std::set<std::uint64_t> keys(some.keys.begin(), some.keys.end());
        EXPECT_TRUE(std::includes(keys.begin(), keys.end(), last.begin(), last.end())) << count;
        last = keys;
    }
    EXPECT_EQ(thin(all, all.size() + 5).keys, all.keys);
    EXPECT_EQ(thin(all, 0).size(), 0U);
}

// Points at random have their nearest neighbour at 0.5 spacings on average, with a standard
// deviation of 0.52 of that; an even spread keeps them far apart.
TEST(Thin, SpreadsWhatItKeepsEvenly) {
    const Follicles all = planted();
    for (const std::size_t count : {200UL, 500UL, 900UL, 1500UL}) {
        const std::vector<double> nearest = nearestDistances(thin(all, count));
        double mean = 0;
        double squares = 0;
        for (const double d : nearest) {
            mean += d / static_cast<double>(nearest.size());
            squares += d * d / static_cast<double>(nearest.size());
        }
        const double ideal =
            all.spacing * std::sqrt(static_cast<double>(all.size()) / static_cast<double>(count));
        EXPECT_GT(mean, 0.72 * ideal) << count;
        EXPECT_LT(std::sqrt(squares - mean * mean), 0.25 * mean) << count;
        EXPECT_GT(*std::min_element(nearest.begin(), nearest.end()), 0.3 * ideal) << count;
    }
}

}  // namespace
}  // namespace kushi
