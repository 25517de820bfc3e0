// SPDX-License-Identifier: Apache-2.0
#include <kushi/strands.h>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

namespace kushi {
namespace {

Strands twoStrands() {
    Strands strands;
    strands.add(std::vector<Vec3f>{{0, 0, 0}, {3, 4, 0}, {3, 4, 2}}, 11);
    strands.add(std::vector<Vec3f>{{-1, 0, 0}, {-1, 1, 0}}, 12);
    return strands;
}

TEST(Strands, AreRagged) {
    const Strands strands = twoStrands();
    EXPECT_EQ(strands.size(), 2U);
    EXPECT_EQ(strands.segmentCount(), 3U);
    EXPECT_EQ(strands.strand(0).size(), 3U);
    EXPECT_EQ(strands.strand(1)[1], (Vec3f{-1, 1, 0}));
}

TEST(Summary, CountsLengthsAndBounds) {
    const GroomSummary summary = summarize(twoStrands());
    EXPECT_EQ(summary.strands, 2U);
    EXPECT_EQ(summary.nodes, 5U);
    EXPECT_EQ(summary.segments, 3U);
    EXPECT_DOUBLE_EQ(summary.minLength, 1);
    EXPECT_DOUBLE_EQ(summary.meanLength, 4);
    EXPECT_DOUBLE_EQ(summary.maxLength, 7);
    EXPECT_EQ(summary.bounds.low, (Vec3f{-1, 0, 0}));
    EXPECT_EQ(summary.bounds.high, (Vec3f{3, 4, 2}));
    EXPECT_THAT(summary.attributes, testing::ElementsAre("key"));
}

TEST(Summary, OfNothingIsNothing) {
    const GroomSummary summary = summarize(Strands{});
    EXPECT_EQ(summary.strands, 0U);
    EXPECT_EQ(summary.maxLength, 0);
    EXPECT_TRUE(summary.bounds.empty());
    EXPECT_EQ(summary.bounds.radius(), 0);
}

}  // namespace
}  // namespace kushi
