// SPDX-License-Identifier: Apache-2.0
#include "pipeline/head_of_hair.h"

#include <kushi/settle.h>

#include <cstring>

#include <gtest/gtest.h>

namespace kushi {
namespace {

const Vec3d band = {-0.115, 0.07, 0};

// Hair all over the top and sides, tied at the back.
Style tied(int count, double length) {
    Style style = headOfHair(count, 40, length);
    HairTie tie;
    tie.at = band;
    style.parts[0].ties.push_back(tie);
    return style;
}

double distanceTo(Vec3d point, std::span<const Vec3f> nodes) {
    double least = 1;
    for (const Vec3f node : nodes)
        least = std::min(least, length(node.as<double>() - point));
    return least;
}

TEST(PartTie, HoldsEveryStrandThatReachesIt) {
    const auto groom = settle(tied(600, 0.35));
    ASSERT_TRUE(groom);
    EXPECT_LE(groom->report.unsettled, 2U);
    EXPECT_LE(groom->report.maxResidual.value_or(1), 1.01e-5);
    for (std::size_t i = 0; i < groom->strands.size(); ++i) {
        const auto nodes = groom->strands.strand(i);
        EXPECT_LT(distanceTo(band, nodes), 0.008 + 1e-4) << i;
        // Behind the band it hangs.
        EXPECT_LT(static_cast<double>(nodes.back().y), band.y);
    }
}

TEST(PartTie, KeepsHairOutOfTheHeadOnItsWay) {
    SettleOptions options;
    options.measurePenetration = true;
    const auto groom = settle(tied(600, 0.35), options);
    ASSERT_TRUE(groom);
    // Chords between nodes on the surface dip by d^2 / (8 r).
    EXPECT_LT(groom->report.penetration.at(0).found.deepest, 2e-4);
}

TEST(PartTie, LeavesHairThatIsTooShort) {
    Style style = tied(400, 0.06);
    const auto groom = settle(style);
    style.parts[0].ties.clear();
    const auto loose = settle(style);
    ASSERT_TRUE(groom && loose);
    std::size_t same = 0;
    for (std::size_t i = 0; i < groom->strands.size(); ++i) {
        const auto nodes = groom->strands.strand(i);
        const bool reached = distanceTo(band, nodes) < 0.009;
        same += !reached && nodes.back() == loose->strands.strand(i).back() ? 1 : 0;
    }
    EXPECT_GT(same, groom->strands.size() / 2);
    EXPECT_LT(same, groom->strands.size());
}

TEST(PartTie, TakesOnlyItsRootsAndTheFirstThatMeets) {
    Style style = tied(400, 0.35);
    // The person's right goes to a band on the right.
    HairTie right;
    right.at = {-0.03, 0.02, 0.115};
    right.roots = {{{0, radians(180)}, {0, radians(180)}}};
    style.parts[0].ties.insert(style.parts[0].ties.begin(), right);
    const auto groom = settle(style);
    ASSERT_TRUE(groom);
    for (std::size_t i = 0; i < groom->strands.size(); ++i) {
        const auto nodes = groom->strands.strand(i);
        const double z = nodes[0].z;
        if (std::abs(z) < 1e-3) continue;
        EXPECT_LT(distanceTo(z > 0 ? right.at : band, nodes), 0.0082) << i;
    }
}

TEST(PartTie, SurvivesACutBehindItAndOneBeforeIt) {
    Style style = tied(200, 0.35);
    Cut cut;
    cut.below = -0.02;
    style.parts[0].cuts.push_back(cut);
    const auto groom = settle(style);
    ASSERT_TRUE(groom);
    EXPECT_EQ(groom->strands.size(), 200U);
    for (std::size_t i = 0; i < groom->strands.size(); ++i) {
        const auto nodes = groom->strands.strand(i);
        EXPECT_LT(distanceTo(band, nodes), 0.0082) << i;
        EXPECT_GT(static_cast<double>(nodes.back().y), -0.035);
    }
    // All above the band: nothing is held any more, and nothing is lost.
    style.parts[0].cuts[0].below.reset();
    style.parts[0].cuts[0].keep = {{0, 0.03}};
    const auto shorn = settle(style);
    ASSERT_TRUE(shorn);
    EXPECT_EQ(shorn->strands.size(), 200U);
}

TEST(PartTie, GivesTheSameBytesOnAnyThreads) {
    SettleOptions one;
    one.threads = 1;
    SettleOptions three;
    three.threads = 3;
    const auto a = settle(tied(400, 0.3), one);
    const auto b = settle(tied(400, 0.3), three);
    ASSERT_TRUE(a && b);
    ASSERT_EQ(a->strands.nodes.size(), b->strands.nodes.size());
    EXPECT_EQ(std::memcmp(a->strands.nodes.data(), b->strands.nodes.data(),
                          a->strands.nodes.size() * sizeof(Vec3f)),
              0);
}

TEST(PartTie, IsNotForTheWalk) {
    SettleOptions walk;
    walk.method = Method::Cantilever;
    const auto groom = settle(tied(10, 0.3), walk);
    ASSERT_FALSE(groom);
    EXPECT_EQ(toString(groom.problems()[0]),
              "error: the hair of 'hair' is tied, which the cantilever method does not know; "
              "settle it by "
              "equilibrium (--method equilibrium)");
}

}  // namespace
}  // namespace kushi
