// SPDX-License-Identifier: Apache-2.0
#include <kushi/settle_groom.h>

#include <cmath>

#include <gtest/gtest.h>

namespace kushi {
namespace {

// Arcs that hang over: roots on a ring, 12 cm long, out and down.
Strands arcs(int count) {
    Strands groom;
    std::vector<Vec3f> nodes;
    for (int i = 0; i < count; ++i) {
        const double turn = 0.7 * i;
        nodes.clear();
        for (int j = 0; j <= 20; ++j) {
            const double a = 0.08 * j;
            const double out = 0.05 + 0.075 * std::sin(a);
            nodes.push_back(
                Vec3d{out * std::cos(turn), 0.075 * (std::cos(a) - 1), out * std::sin(turn)}
                    .as<float>());
        }
        groom.add(nodes, static_cast<std::uint64_t>(i));
    }
    groom.colors.assign(groom.nodes.size(), Rgb{0.1F, 0.2F, 0.3F});
    groom.transparency.assign(groom.nodes.size(), 0.25F);
    return groom;
}

float meanTipHeight(const Strands& groom) {
    float sum = 0;
    for (std::size_t i = 0; i < groom.size(); ++i)
        sum += groom.strand(i).back().y;
    return sum / static_cast<float>(groom.size());
}

SettledStrands settled(const GroomSettleOptions& options, const Strands& groom = arcs(20)) {
    return *settleGroom(groom, options);
}

TEST(SettleGroom, UnchangedItStaysWhereItIsWithAllItHas) {
    const Strands groom = arcs(20);
    const SettledStrands same = settled({});
    for (std::size_t j = 0; j < groom.nodes.size(); ++j)
        EXPECT_LT(length(same.strands.nodes[j] - groom.nodes[j]), 1e-5F * 0.12F);
    EXPECT_EQ(same.strands.offsets, groom.offsets);
    EXPECT_EQ(same.strands.keys, groom.keys);
    EXPECT_EQ(same.strands.colors, groom.colors);
    EXPECT_EQ(same.strands.transparency, groom.transparency);
    EXPECT_EQ(same.report.strands, 20U);
    EXPECT_EQ(same.report.segments, 400U);
    EXPECT_EQ(same.report.unsettled, 0U);
    EXPECT_LT(same.report.maxResidual, 1e-5);
}

TEST(SettleGroom, HeavierHairFallsAndStifferHairSprings) {
    const float before = meanTipHeight(arcs(20));
    GroomSettleOptions wet;
    wet.weightScale = 1.5;
    EXPECT_LT(meanTipHeight(settled(wet).strands), before - 0.005F);
    GroomSettleOptions dry;
    dry.weightScale = 0.5;
    EXPECT_GT(meanTipHeight(settled(dry).strands), before + 0.005F);
    GroomSettleOptions stiff;
    stiff.stiffnessScale = 2;
    // Twice as stiff bends as half as heavy does.
    EXPECT_NEAR(meanTipHeight(settled(stiff).strands), meanTipHeight(settled(dry).strands), 1e-4F);
}

TEST(SettleGroom, UpsideDownItFallsTheOtherWay) {
    GroomSettleOptions headstand;
    headstand.gravity = {0, 1, 0};
    headstand.weightScale = 3;
    EXPECT_GT(meanTipHeight(settled(headstand).strands), 0.05F);
}

TEST(SettleGroom, AStrandThatHangsStraightFallsWhenItIsTurnedUpsideDown) {
    Strands groom;
    std::vector<Vec3f> nodes;
    for (int j = 0; j <= 20; ++j)
        nodes.push_back({0, -0.01F * static_cast<float>(j), 0});
    groom.add(nodes, 3);
    GroomSettleOptions headstand;
    headstand.gravity = {0, 1, 0};
    const SettledStrands turned = settled(headstand, groom);
    EXPECT_EQ(turned.report.unsettled, 0U);
    EXPECT_GT(turned.strands.nodes.back().y, 0.1F);
    for (std::size_t j = 1; j < 21; ++j)
        EXPECT_NEAR(length(turned.strands.nodes[j] - turned.strands.nodes[j - 1]), 0.01F, 1e-6F);
}

TEST(SettleGroom, WithoutItsSetItIsStraightHair) {
    GroomSettleOptions none;
    none.set = 0;
    none.gravity = {0, 0, 0};
    const SettledStrands straight = settled(none);
    for (std::size_t i = 0; i < 20; ++i) {
        const auto strand = straight.strands.strand(i);
        EXPECT_NEAR(length(strand.back() - strand.front()), polylineLength(strand), 1e-5);
    }
}

TEST(SettleGroom, SidewaysIsDownWhereTheFileSaysSo) {
    Strands lying = arcs(20);
    for (Vec3f& node : lying.nodes)
        node = {node.y, -node.x, node.z};
    GroomSettleOptions options;
    options.setGravity = {-1, 0, 0};
    options.gravity = {-1.5, 0, 0};
    GroomSettleOptions upright;
    upright.gravity = {0, -1.5, 0};
    const SettledStrands a = settled(options, lying);
    const SettledStrands b = settled(upright);
    for (std::size_t j = 0; j < lying.nodes.size(); ++j) {
        const Vec3f turned = {a.strands.nodes[j].x, a.strands.nodes[j].y, a.strands.nodes[j].z};
        const Vec3f same = {b.strands.nodes[j].y, -b.strands.nodes[j].x, b.strands.nodes[j].z};
        EXPECT_LT(length(turned - same), 1e-3F * 0.12F);
    }
}

TEST(SettleGroom, TheSameFromAnyNumberOfThreads) {
    GroomSettleOptions options;
    options.gravity = {1, 0.5, 0};
    options.threads = 1;
    const SettledStrands one = settled(options, arcs(700));
    options.threads = 5;
    EXPECT_EQ(settled(options, arcs(700)).strands.nodes, one.strands.nodes);
}

TEST(SettleGroom, NoStrandsAreNoTrouble) {
    EXPECT_EQ(settled({}, Strands{}).report.strands, 0U);
}

}  // namespace
}  // namespace kushi
