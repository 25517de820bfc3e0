// SPDX-License-Identifier: Apache-2.0
//
// Grooms made elsewhere that rest against solids.
#include "farthest.h"
#include "geometry/solids.h"

#include <kushi/rest_shape.h>
#include <kushi/settle.h>
#include <kushi/settle_groom.h>

#include <algorithm>
#include <cmath>
#include <fstream>
#include <limits>

#include <gtest/gtest.h>

namespace kushi {
namespace {

using test::farthest;

// 10 cm wide and deep and 16 cm high, its top at y = 0.
Mesh blockMesh() {
    Mesh mesh = test::box({0.05F, 0.08F, 0.05F});
    for (Vec3f& vertex : mesh.vertices)
        vertex.y -= 0.08F;
    return mesh;
}

DistanceField block() {
    const Solid solid = {blockMesh(), 0};
    return *distanceFieldOf({&solid, 1}, {});
}

// > 0 in the block.
double depthInBlock(Vec3d at) {
    return 0.05 - std::max({std::abs(at.x), std::abs(at.y + 0.08) - 0.03, std::abs(at.z)});
}

double deepest(std::span<const Vec3f> nodes) {
    double deep = -1;
    for (std::size_t j = 1; j < nodes.size(); ++j) {
        const Vec3d from = nodes[j - 1].as<double>();
        const Vec3d way = nodes[j].as<double>() - from;
        for (int k = 1; k <= 8; ++k)
            deep = std::max(deep, depthInBlock(from + (k / 8.0) * way));
    }
    return deep;
}

double deepest(const Strands& groom) {
    double deep = -1;
    for (std::size_t i = 0; i < groom.size(); ++i)
        deep = std::max(deep, deepest(groom.strand(i)));
    return deep;
}

// Straight strands along x that begin over the block and reach beyond it.
Strands beams(float height, float length = 0.14F) {
    Strands groom;
    std::vector<Vec3f> nodes;
    for (int i = 0; i < 8; ++i) {
        const float z = -0.035F + 0.01F * static_cast<float>(i);
        nodes.clear();
        for (int j = 0; j <= 28; ++j)
            nodes.push_back({-0.03F + length / 28 * static_cast<float>(j), height, z});
        groom.add(nodes, static_cast<std::uint64_t>(i));
    }
    return groom;
}

// Hair of which nothing is set any more lies over the block as hair does that grows there.
TEST(GroomOnSolids, LiesOnThemAsGrownHairDoes) {
    const DistanceField solids = block();
    const Strands groom = beams(0.01F);
    GroomSettleOptions options;
    options.set = 0;
    const SettledStrands through = *settleGroom(groom, options);
    EXPECT_GT(deepest(through.strands), 0.01);
    EXPECT_FALSE(through.report.penetration);
    options.solids = &solids;
    const SettledStrands lying = *settleGroom(groom, options);
    EXPECT_LT(deepest(lying.strands), 0);
    EXPECT_EQ(lying.report.unsettled, 0U);
    EXPECT_EQ(lying.report.pushedOut, 0U);
    EXPECT_EQ(lying.report.stuck, 0U);
    ASSERT_TRUE(lying.report.penetration);
    EXPECT_EQ(lying.report.penetration->strands, 0U);

    Rods rods;
    for (std::size_t i = 0; i < groom.size(); ++i) {
        rods.roots.push_back(groom.strand(i)[0]);
        rods.clamps.push_back(frameAlong({1, 0, 0}));
        rods.lengths.push_back(static_cast<float>(polylineLength(groom.strand(i))));
        rods.bending.push_back(static_cast<float>(Hair().rigidity()));
        rods.twisting.push_back(static_cast<float>(Hair().torsionalRigidity()));
        rods.weights.push_back(static_cast<float>(Hair().weightPerLength()));
        rods.keys.push_back(groom.keys[i]);
        rods.offsets.push_back(rods.offsets.back() + 28);
    }
    RodWorld world;
    world.solids = &solids;
    RestState state;
    Strands grown = groom;
    const RestReport report = settleRods(rods, world, state, grown.nodes, {});
    ASSERT_TRUE(report.unsettled.empty());
    EXPECT_LT(grown.strand(4).back().y, -0.01F);  // over the edge
    EXPECT_LT(farthest(lying.strands, grown), 1e-3F);
}

// At rest, and not merely pushed out: nothing moves when it is set anew where it lies.
TEST(GroomOnSolids, StaysWhereItLies) {
    const DistanceField solids = block();
    GroomSettleOptions options;
    options.solids = &solids;
    options.set = 0.3;
    const Strands lying = settleGroom(beams(0.008F), options)->strands;
    EXPECT_GT(deepest(lying), -0.002);  // it does lie on it
    options.set = 1;
    const SettledStrands same = *settleGroom(lying, options);
    EXPECT_EQ(same.report.pushedOut, 0U);
    EXPECT_LT(farthest(same.strands, lying), 1e-4F * 0.14F);
    // And heavier hair does not go through.
    options.weightScale = 4;
    const SettledStrands heavy = *settleGroom(lying, options);
    EXPECT_EQ(heavy.report.unsettled, 0U);
    EXPECT_LT(deepest(heavy.strands), 0);
    EXPECT_GT(farthest(heavy.strands, lying), 2e-3F);
}

TEST(GroomOnSolids, WhatLiesInThemIsTurnedOutFirst) {
    const DistanceField solids = block();
    Strands groom = beams(0.01F);
    const Strands through = beams(-0.0213F);
    for (std::size_t i = 0; i < through.size(); ++i) {
        std::vector<Vec3f> nodes(through.strand(i).begin(), through.strand(i).end());
        for (Vec3f& node : nodes)
            node.x -= 0.05F;  // from outside through and out again
        groom.add(nodes, 100 + i);
    }
    GroomSettleOptions options;
    options.solids = &solids;
    const SettledStrands clean = *settleGroom(groom, options);
    EXPECT_EQ(clean.report.pushedOut, 8U);
    EXPECT_EQ(clean.report.stuck, 0U);
    EXPECT_LT(deepest(clean.strands), 0);
    for (std::size_t i = 0; i < groom.size(); ++i) {
        EXPECT_EQ(clean.strands.strand(i)[0], groom.strand(i)[0]);
        EXPECT_NEAR(polylineLength(clean.strands.strand(i)), 0.14, 1e-5);
    }
    // Those that lay free are where they are without solids.
    options.solids = nullptr;
    const SettledStrands plain = *settleGroom(groom, options);
    for (std::size_t j = 0; j < 8 * 29; ++j)
        EXPECT_EQ(clean.strands.nodes[j], plain.strands.nodes[j]);
}

// Strands that begin 2 mm in the block, as roots of scans do, upright and at a slant.
Strands rooted() {
    Strands groom;
    std::vector<Vec3f> nodes;
    for (int i = 0; i < 6; ++i) {
        const float slant = 0.15F * static_cast<float>(i);
        nodes.clear();
        for (int j = 0; j <= 40; ++j) {
            const float along = 0.003F * static_cast<float>(j);
            nodes.push_back({-0.03F + along * std::sin(slant), -0.002F + along * std::cos(slant),
                             -0.03F + 0.012F * static_cast<float>(i)});
        }
        groom.add(nodes, static_cast<std::uint64_t>(i));
    }
    return groom;
}

TEST(GroomOnSolids, RootsInTheSkinHoldTheirStrandsWhereTheyComeOut) {
    const DistanceField solids = block();
    const Strands groom = rooted();
    GroomSettleOptions options;
    options.solids = &solids;
    const SettledStrands same = *settleGroom(groom, options);
    EXPECT_EQ(same.report.unsettled, 0U);
    EXPECT_LT(farthest(same.strands, groom), 1e-4F * 0.12F);
    options.set = 0.1;
    options.gravity = {0.3, -1.5, 0};
    const SettledStrands fallen = *settleGroom(groom, options);
    EXPECT_EQ(fallen.report.unsettled, 0U);
    EXPECT_EQ(fallen.report.stuck, 0U);
    for (std::size_t i = 0; i < groom.size(); ++i) {
        const auto nodes = fallen.strands.strand(i);
        EXPECT_LT(length(nodes[0] - groom.strand(i)[0]), 1e-8F);
        EXPECT_LT(deepest(nodes.subspan(3)), 0) << i;  // 9 mm from the root
        EXPECT_LT(nodes.back().y, 0.06F) << i;
        EXPECT_NEAR(polylineLength(nodes), 0.12, 1e-5);
    }
}

TEST(GroomOnSolids, WhatNeverComesOutStaysAndIsCounted) {
    const DistanceField solids = block();
    Strands groom;
    groom.add(std::vector<Vec3f>{{0, -0.05F, 0}, {0, -0.04F, 0}, {0, -0.03F, 0}}, 7);
    GroomSettleOptions options;
    options.solids = &solids;
    options.gravity = {0, 1, 0};
    const SettledStrands buried = *settleGroom(groom, options);
    EXPECT_EQ(buried.report.penetration->strands, 1U);
    EXPECT_NEAR(buried.report.penetration->deepest, 0.05, 1e-3);
    EXPECT_LT(farthest(buried.strands, groom), 1e-8F);
}

TEST(GroomOnSolids, TheSameFromAnyNumberOfThreads) {
    const DistanceField solids = block();
    Strands groom = rooted();
    for (std::size_t i = 0; i < 8; ++i)
        groom.add(beams(0.01F).strand(i), 50 + i);
    GroomSettleOptions options;
    options.solids = &solids;
    options.set = 0.2;
    options.threads = 1;
    const SettledStrands one = *settleGroom(groom, options);
    options.threads = 5;
    EXPECT_EQ(settleGroom(groom, options)->strands.nodes, one.strands.nodes);
}

TEST(GroomOnSolids, WhatIsWrongIsSaid) {
    const DistanceField solids = block();
    GroomSettleOptions options;
    options.solids = &solids;
    Strands groom = rooted();
    groom.offsets.push_back(groom.offsets.back());
    groom.keys.push_back(9);
    EXPECT_FALSE(settleGroom(groom, options));
    groom = rooted();
    groom.nodes[5].x = std::numeric_limits<float>::infinity();
    EXPECT_FALSE(settleGroom(groom, options));
    EXPECT_EQ(settleGroom(Strands(), options)->report.strands, 0U);
}

// A style with the block as its only solid, and the beams as its hair.
Style styleOf(const Strands& groom) {
    const auto* test = testing::UnitTest::GetInstance()->current_test_info();
    const std::string folder = testing::TempDir() + "groom-on-solids-" + test->name();
    const Mesh mesh = blockMesh();
    std::string obj;
    for (const Vec3f v : mesh.vertices) {
        obj += "v " + std::to_string(100 * v.x) + ' ' + std::to_string(100 * v.y) + ' ' +
               std::to_string(100 * v.z) + '\n';
    }
    for (const auto& [a, b, c] : mesh.triangles) {
        obj += "f " + std::to_string(a + 1) + ' ' + std::to_string(b + 1) + ' ' +
               std::to_string(c + 1) + '\n';
    }
    std::ofstream(folder + ".obj") << obj;
    EXPECT_TRUE(writeGroom(groom, folder + ".ply").ok());
    Style style;
    style.solver.method = Method::Equilibrium;
    style.headMesh = "none";
    style.colliders.resize(1);
    style.colliders[0].mesh = folder + ".obj";
    style.colliders[0].placement.front = {1, 0, 0};
    style.colliders[0].placement.origin = MeshOrigin::File;
    style.parts.resize(1);
    style.parts[0].name = "scan";
    style.parts[0].scalp.ellipsoid = {{}, {0.1, 0.1, 0.1}, 0};
    style.parts[0].groom.emplace();
    style.parts[0].groom->path = folder + ".ply";
    return style;
}

SettledGroom settled(const Style& style) {
    SettleOptions options;
    options.measurePenetration = true;
    auto groom = settle(style, options);
    EXPECT_TRUE(groom) << toString(groom.problems()[0]);
    return groom ? std::move(*groom) : SettledGroom();
}

TEST(GroomOnSolids, PartsOfStylesDoAsWell) {
    Style style = styleOf(beams(0.01F));
    style.parts[0].hair.set = 0;
    const SettledGroom lying = settled(style);
    EXPECT_EQ(lying.report.unsettled, 0U);
    EXPECT_LT(deepest(lying.strands), 0);
    EXPECT_LT(lying.strands.strand(4).back().y, -0.01F);
    ASSERT_EQ(lying.report.penetration.size(), 1U);
    EXPECT_EQ(lying.report.penetration[0].part, "scan");
    EXPECT_EQ(lying.report.penetration[0].found.strands, 0U);
    const DistanceField solids = block();
    GroomSettleOptions options;
    options.solids = &solids;
    options.set = 0;
    EXPECT_LT(farthest(lying.strands, settleGroom(beams(0.01F), options)->strands), 1e-4F);

    style.colliders.clear();
    const SettledGroom free = settled(style);
    EXPECT_GT(deepest(free.strands), 0.01);
    EXPECT_TRUE(free.report.penetration.empty());
}

// Cuts count from the root, also where that is in the skin; what is cut rests on the block.
TEST(GroomOnSolids, CutsCountFromTheRoot) {
    Style style = styleOf(rooted());
    style.parts[0].hair.set = 0.1;
    for (const CutMode mode : {CutMode::Hide, CutMode::Settle}) {
        Cut cut;
        cut.keep = {{0, 0.0717}};
        cut.mode = mode;
        style.parts[0].cuts = {cut};
        const SettledGroom cutHair = settled(style);
        EXPECT_EQ(cutHair.report.unsettled, 0U);
        for (std::size_t i = 0; i < 6; ++i) {
            EXPECT_NEAR(polylineLength(cutHair.strands.strand(i)), 0.0717, 1e-5);
            EXPECT_LT(deepest(cutHair.strands.strand(i).subspan(3)), 0) << i;
        }
        // Within what is in the skin.
        style.parts[0].cuts[0].keep = {{0, 0.001}};
        for (std::size_t i = 0; i < 6; ++i)
            EXPECT_LE(polylineLength(settled(style).strands.strand(i)), 0.0031);
    }
}

}  // namespace
}  // namespace kushi
