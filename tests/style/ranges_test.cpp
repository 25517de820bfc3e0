// SPDX-License-Identifier: Apache-2.0
#include "style/ranges.h"

#include <gtest/gtest.h>

namespace kushi {
namespace {

const RootRanges sides = {{{0.5, 1.5}, {1, 2}}, {{0.5, 1.5}, {-2, -1}}};

TEST(RootRanges, HoldWhatAnyOfThemHolds) {
    EXPECT_TRUE(contains(sides, {1, 1.5}));
    EXPECT_TRUE(contains(sides, {1, -1.5}));
    EXPECT_TRUE(contains(sides, {1.5, -2}));
    EXPECT_FALSE(contains(sides, {1, 0}));
    EXPECT_FALSE(contains(sides, {1.6, 1.5}));
    EXPECT_TRUE(contains(RootRanges(1), {3, 3}));
    EXPECT_FALSE(contains(RootRanges(), {1, 1}));
}

TEST(RootRanges, ShareAsMuchAsTheLargestOfThem) {
    EXPECT_NEAR(share(sides, {1, 1}, 0.1), 0.5, 1e-12);
    EXPECT_NEAR(share(sides, {1, -2}, 0.1), 0.5, 1e-12);
    EXPECT_EQ(share(sides, {1, -1.5}, 0.1), 1);
    EXPECT_EQ(share(sides, {1, 0}, 0.1), 0);
    const RootRanges overlapping = {{{0, 1}, {0, 2}}, {{0, 1}, {1, 3}}};
    EXPECT_EQ(share(overlapping, {0.5, 1}, 0.1), 1);
    EXPECT_EQ(share(RootRanges(), {1, 1}, 0.1), 0);
}

}  // namespace
}  // namespace kushi
