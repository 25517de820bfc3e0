// SPDX-License-Identifier: Apache-2.0
//
// Clumps and flyaways of whole heads.
#include "fields.h"
#include "pipeline/head_of_hair.h"

#include <kushi/settle.h>

#include <algorithm>

#include <gtest/gtest.h>

namespace kushi {
namespace {

Style dressedHead(int count, Method method) {
    Style style = headOfHair(count, 24, 0.2);
    style.headCollides = true;
    style.solver.method = method;
    style.parts[0].hair.clump.amount = 0.7;
    style.parts[0].hair.clump.size = 0.02;
    style.parts[0].hair.flyaway = {0.05, 0.02};
    return style;
}

Style undressed(Style style) {
    style.parts[0].hair.clump.amount = 0;
    style.parts[0].hair.flyaway.share = 0;
    return style;
}

SettledGroom settled(const Style& style, SettleOptions options = {}) {
    options.cacheFolder = test::fieldCache();
    options.measurePenetration = true;
    auto groom = settle(style, options);
    EXPECT_TRUE(groom.ok());
    return std::move(*groom);
}

class DressedHair : public testing::TestWithParam<Method> {};

TEST_P(DressedHair, IsOutsideOfTheHead) {
    const Style style = dressedHead(1500, GetParam());
    const SettledGroom plain = settled(undressed(style));
    const SettledGroom groom = settled(style);
    EXPECT_GT(groom.report.clumps, 50U);
    EXPECT_GT(groom.report.flyaways, 40U);
    EXPECT_EQ(groom.report.stages.back().stage, "dress");
    EXPECT_EQ(groom.report.stuck, plain.report.stuck);
    EXPECT_EQ(groom.report.penetration.at(0).found.strands, 0U);
    ASSERT_EQ(groom.strands.keys, plain.strands.keys);
    std::size_t moved = 0;
    for (std::size_t i = 0; i < groom.strands.size(); ++i) {
        EXPECT_EQ(groom.strands.strand(i)[0], plain.strands.strand(i)[0]);
        EXPECT_LT(polylineLength(groom.strands.strand(i)), 0.2 + 1e-6);
        moved +=
            length(groom.strands.strand(i).back() - plain.strands.strand(i).back()) > 1e-3F ? 1 : 0;
    }
    EXPECT_GT(moved, groom.strands.size() / 2);
    EXPECT_EQ(groom.innerEnds, plain.innerEnds);
}

TEST_P(DressedHair, IsNoDeeperInTheEllipsoidThanItWas) {
    Style style = dressedHead(600, GetParam());
    style.headCollides = false;
    const double before = settled(undressed(style)).report.penetration.at(0).found.deepest;
    const double after = settled(style).report.penetration.at(0).found.deepest;
    EXPECT_LE(after, std::max(before, 6e-5));
}

TEST_P(DressedHair, OfNoAmountIsAsItRests) {
    const Style plain = undressed(dressedHead(300, GetParam()));
    Style other = plain;
    other.parts[0].hair.clump = {0, 0.03, 0.9, 0.5};
    other.parts[0].hair.flyaway.distance = 0.1;
    const SettledGroom one = settled(plain);
    const SettledGroom two = settled(other);
    EXPECT_EQ(one.strands.nodes, two.strands.nodes);
    EXPECT_EQ(two.report.clumps, 0U);
    EXPECT_EQ(two.report.flyaways, 0U);
    EXPECT_NE(two.report.stages.back().stage, "dress");
}

INSTANTIATE_TEST_SUITE_P(Methods, DressedHair,
                         testing::Values(Method::Cantilever, Method::Equilibrium));

TEST(DressedHair, IsTheSameFromAnyNumberOfThreads) {
    const Style style = dressedHead(800, Method::Cantilever);
    SettleOptions options;
    options.threads = 1;
    const SettledGroom one = settled(style, options);
    options.threads = 3;
    EXPECT_EQ(one.strands.nodes, settled(style, options).strands.nodes);
}

// Clumps are where they are in the whole, and go nearly to where they go there.
TEST(DressedHair, OfAPreviewIsAlike) {
    Style style = dressedHead(8000, Method::Cantilever);
    style.parts[0].hair.flyaway.share = 0;
    const SettledGroom plain = settled(undressed(style));
    const SettledGroom all = settled(style);
    SettleOptions options;
    options.count = 2000;
    const SettledGroom few = settled(style, options);
    EXPECT_NEAR(static_cast<double>(few.report.clumps), static_cast<double>(all.report.clumps),
                0.05 * static_cast<double>(all.report.clumps));
    double drawn = 0;
    double differ = 0;
    std::size_t at = 0;
    for (std::size_t i = 0; i < few.strands.size(); ++i) {
        while (all.strands.keys[at] != few.strands.keys[i])
            ++at;
        const Vec3f tip = all.strands.strand(at).back();
        drawn += double{length(tip - plain.strands.strand(at).back())};
        differ += double{length(tip - few.strands.strand(i).back())};
    }
    EXPECT_LT(differ, 0.5 * drawn);
}

TEST(DressedHair, GoesWithHideCuts) {
    Style style = dressedHead(800, Method::Cantilever);
    Cut cut;
    cut.below = 0.02;
    cut.mode = CutMode::Hide;
    style.parts[0].cuts = {cut};
    const SettledGroom plain = settled(undressed(style));
    const SettledGroom groom = settled(style);
    ASSERT_EQ(groom.strands.keys, plain.strands.keys);
    EXPECT_EQ(groom.innerEnds, plain.innerEnds);
    EXPECT_EQ(groom.report.penetration.at(0).found.strands, 0U);
    for (std::size_t i = 0; i < groom.strands.size(); ++i) {
        ASSERT_EQ(groom.strands.strand(i).size(), plain.strands.strand(i).size());
        EXPECT_LE(polylineLength(groom.strands.strand(i)),
                  polylineLength(plain.strands.strand(i)) + 1e-6);
    }
}

// The band still holds what it held, but for flyaways.
TEST(DressedHair, StaysInItsTie) {
    Style style = dressedHead(600, Method::Equilibrium);
    style.parts[0].hair.length = 0.35;
    style.parts[0].hair.flyaway.share = 0;
    style.parts[0].hair.clump.size = 0.008;
    style.solver.segments = 40;
    HairTie tie;
    tie.at = {-0.115, 0.07, 0};
    style.parts[0].ties.push_back(tie);
    const SettledGroom groom = settled(style);
    EXPECT_GT(groom.report.clumps, 50U);
    for (std::size_t i = 0; i < groom.strands.size(); ++i) {
        double least = 1;
        for (const Vec3f node : groom.strands.strand(i))
            least = std::min(least, length(node.as<double>() - tie.at));
        EXPECT_LT(least, 0.012) << i;
    }
}

}  // namespace
}  // namespace kushi
