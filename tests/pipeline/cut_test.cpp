// SPDX-License-Identifier: Apache-2.0
#include "pipeline/cut.h"

#include <gtest/gtest.h>

namespace kushi {
namespace {

// Up 1, right 2, down 3.
const std::vector<Vec3d> hook = {{0, 0, 0}, {0, 1, 0}, {2, 1, 0}, {2, -2, 0}};

TEST(CutBelow, LeavesWhatLiesBeforeTheFirstPassage) {
    Cut cut;
    cut.below = -0.5;
    EXPECT_DOUBLE_EQ(*lengthLeft(cut, hook), 1 + 2 + 1.5);
    cut.below = 0;
    EXPECT_DOUBLE_EQ(*lengthLeft(cut, hook),
                     1 + 2 + 1);  // the follicle at the height is not below it
    cut.below = 0.5;
    EXPECT_EQ(*lengthLeft(cut, hook), 0);
    cut.below = -2;
    EXPECT_FALSE(lengthLeft(cut, hook));
}

TEST(CutKeep, InterpolatesTheLengthByTheHeightOfTheRoot) {
    Cut cut;
    cut.keep = {{-1, 2}, {1, 4}, {2, 1}};
    const auto rootAt = [](double y) { return std::vector<Vec3d>{{0, y, 0}, {10, y, 0}}; };
    EXPECT_DOUBLE_EQ(*lengthLeft(cut, rootAt(0.5)), 3.5);
    EXPECT_DOUBLE_EQ(*lengthLeft(cut, rootAt(1.5)), 2.5);
    EXPECT_DOUBLE_EQ(*lengthLeft(cut, rootAt(-1)), 2);
    EXPECT_DOUBLE_EQ(*lengthLeft(cut, rootAt(-7)), 2);
    EXPECT_DOUBLE_EQ(*lengthLeft(cut, rootAt(7)), 1);
    cut.keep = {{0, 11}};
    EXPECT_FALSE(lengthLeft(cut, rootAt(0)));
}

// Each strand its own height; together they cover the width.
TEST(CutBelow, IsSpreadOverTheWidthOfItsFalloff) {
    Cut cut;
    cut.below = -0.5;
    cut.falloff.distance = 0.4;
    EXPECT_DOUBLE_EQ(*lengthLeft(cut, hook, 0), 4.5);
    EXPECT_DOUBLE_EQ(*lengthLeft(cut, hook, 1), 4.7);
    EXPECT_DOUBLE_EQ(*lengthLeft(cut, hook, -1), 4.3);
}

TEST(CutKeep, IsSpreadOverTheWidthOfItsFalloff) {
    Cut cut;
    cut.keep = {{0, 1}};
    cut.falloff.distance = 0.4;
    EXPECT_DOUBLE_EQ(*lengthLeft(cut, hook, 1), 1.2);
    EXPECT_DOUBLE_EQ(*lengthLeft(cut, hook, -1), 0.8);
    cut.falloff.distance = 4;
    EXPECT_EQ(*lengthLeft(cut, hook, -1), 0);
}

// The hook is 6 long; the cut would take 1.5 of it.
TEST(CutBelow, TakesAShareOfWhatItWouldTake) {
    Cut cut;
    cut.below = -0.5;
    EXPECT_DOUBLE_EQ(*lengthLeft(cut, hook, 0, 1), 4.5);
    EXPECT_DOUBLE_EQ(*lengthLeft(cut, hook, 0, 0.5), 5.25);
    cut.below = -3;
    EXPECT_FALSE(lengthLeft(cut, hook, 0, 0.5));
}

TEST(Clipped, EndsOnTheSegment) {
    EXPECT_EQ(clipped(hook, 2.5), (std::vector<Vec3d>{{0, 0, 0}, {0, 1, 0}, {1.5, 1, 0}}));
    EXPECT_EQ(clipped(hook, 3), (std::vector<Vec3d>{{0, 0, 0}, {0, 1, 0}, {2, 1, 0}}));
    EXPECT_EQ(clipped(hook, 99), hook);
}

}  // namespace
}  // namespace kushi
