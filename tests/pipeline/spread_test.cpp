// SPDX-License-Identifier: Apache-2.0
#include "pipeline/spread.h"

#include "core/random.h"

#include <algorithm>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

namespace kushi {
namespace {

std::vector<Vec3f> randomPoints(std::size_t count) {
    std::vector<Vec3f> points;
    for (std::uint64_t i = 0; i < count; ++i)
        points.push_back(Vec3d{uniform(3 * i), uniform(3 * i + 1), 0}.as<float>());
    return points;
}

TEST(SpreadSubset, TakesTheNumberAskedForInOrder) {
    const auto points = randomPoints(1000);
    for (const std::size_t count : {0, 1, 2, 7, 500, 999}) {
        const auto taken = spreadSubset(points, count);
        EXPECT_EQ(taken.size(), count);
        EXPECT_TRUE(std::is_sorted(taken.begin(), taken.end()));
        EXPECT_EQ(std::adjacent_find(taken.begin(), taken.end()), taken.end());
    }
    EXPECT_EQ(spreadSubset(points, 1000).size(), 1000U);
    EXPECT_EQ(spreadSubset(points, 5000).size(), 1000U);
    EXPECT_TRUE(spreadSubset({}, 3).empty());
}

TEST(SpreadSubset, OfFewerIsPartOfThatOfMore) {
    const auto points = randomPoints(1000);
    const auto some = spreadSubset(points, 100);
    const auto more = spreadSubset(points, 333);
    EXPECT_TRUE(std::includes(more.begin(), more.end(), some.begin(), some.end()));
}

// A random choice of 64 out of 16 squares leaves the counts with a variance of about 4.
TEST(SpreadSubset, LeavesNoGapsAndNoCrowds) {
    const auto points = randomPoints(4096);
    int counts[16] = {};
    for (const std::uint32_t i : spreadSubset(points, 64)) {
        const auto cell = [](float x) { return static_cast<int>(4 * x); };
        ++counts[4 * cell(points[i].y) + cell(points[i].x)];
    }
    double variance = 0;
    for (const int count : counts)
        variance += (count - 4) * (count - 4) / 16.0;
    EXPECT_LT(variance, 1);
}

TEST(SpreadSubset, MayBeOfPointsThatCoincide) {
    const std::vector<Vec3f> same(100, Vec3f{1, 2, 3});
    EXPECT_EQ(spreadSubset(same, 30).size(), 30U);
}

}  // namespace
}  // namespace kushi
