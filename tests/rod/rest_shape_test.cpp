// SPDX-License-Identifier: Apache-2.0
#include "core/random.h"

#include <kushi/rest_shape.h>

#include <cmath>
#include <limits>
#include <numbers>

#include <gtest/gtest.h>

namespace kushi {
namespace {

// Medium hair [N m2, N/m].
constexpr double bending = 6.06e-9;
constexpr double weight = 5.72e-5;

// Length at which w L^3 / EI is gamma [m].
double lengthOf(double gamma) {
    return std::cbrt(gamma * bending / weight);
}

StrandMaterials medium(std::size_t strands) {
    StrandMaterials materials;
    materials.bending.assign(strands, static_cast<float>(bending));
    materials.twisting.assign(strands, static_cast<float>(0.5 * bending));
    materials.weights.assign(strands, static_cast<float>(weight));
    return materials;
}

Strands groomOf(const std::vector<std::vector<Vec3d>>& strands) {
    Strands groom;
    std::vector<Vec3f> nodes;
    for (const auto& strand : strands) {
        nodes.clear();
        for (const Vec3d node : strand)
            nodes.push_back(node.as<float>());
        groom.add(nodes, groom.size());
    }
    return groom;
}

std::vector<Vec3d> straight(Vec3d root, Vec3d step, int segments) {
    std::vector<Vec3d> nodes;
    for (int j = 0; j <= segments; ++j)
        nodes.push_back(root + static_cast<double>(j) * step);
    return nodes;
}

// A smooth random curve: its curvature about two axes is a sum of three waves.
std::vector<Vec3d> smooth(std::uint64_t key, double size, int segments) {
    const auto random = [&](int i) {
        return uniformSigned(mixKey(key, static_cast<std::uint64_t>(i)));
    };
    std::vector<Vec3d> nodes = {{0.1 * random(0), 0.1 * random(1), 0.1 * random(2)}};
    Vec3d t = normalized(Vec3d{random(3), random(4), random(5)});
    Vec3d n = normalized(cross(t, Vec3d{random(6), random(7), random(8)}));
    constexpr int fine = 20;
    const double d = size / segments;
    for (int j = 0; j < segments; ++j) {
        // Uneven: segments between half and once and a half the mean.
        const double own = d * (1 + 0.5 * random(100 + j)) / fine;
        Vec3d at = nodes.back();
        for (int k = 0; k < fine; ++k) {
            const double s = (j + static_cast<double>(k) / fine) / segments;
            const double k1 =
                random(9) + random(10) * std::sin(6 * s) + random(11) * std::cos(9 * s);
            const double k2 =
                random(12) + random(13) * std::sin(6 * s) + random(14) * std::cos(9 * s);
            t = normalized(t + own / size * 2.5 * (k1 * n + k2 * cross(t, n)));
            n = normalized(n - dot(n, t) * t);
            at += own * t;
        }
        nodes.push_back(at);
    }
    return nodes;
}

Strands smoothGroom(int strands, double gamma) {
    std::vector<std::vector<Vec3d>> all;
    all.reserve(static_cast<std::size_t>(strands));
    for (int i = 0; i < strands; ++i)
        all.push_back(
            smooth(mixKey(7, static_cast<std::uint64_t>(i)), lengthOf(gamma), 12 + i % 9));
    return groomOf(all);
}

// Farthest that any node of strand i is from where it was, over the strand's length.
double moved(const Strands& from, std::span<const Vec3f> to, std::size_t i) {
    double most = 0;
    for (std::size_t j = from.offsets[i]; j < from.offsets[i + 1]; ++j)
        most = std::max(most, length(to[j].as<double>() - from.nodes[j].as<double>()));
    return most / std::max(polylineLength(from.strand(i)), 1e-9);
}

double moved(const Strands& from, std::span<const Vec3f> to) {
    double most = 0;
    for (std::size_t i = 0; i < from.size(); ++i)
        most = std::max(most, moved(from, to, i));
    return most;
}

struct Settled {
    std::vector<Vec3f> nodes;  // of the groom
    RestReport report;
};

Settled settleSet(const SetGroom& set, const RodWorld& world, RestState& state, bool warm = false) {
    std::vector<Vec3f> rodNodes(set.rods.nodeCount());
    RestOptions options;
    options.warm = warm;
    Settled settled;
    settled.report = settleRods(set.rods, world, state, rodNodes, options);
    settled.nodes.resize(set.nodes.size());
    placeNodes(set, rodNodes, settled.nodes);
    return settled;
}

Settled settleSet(const SetGroom& set, const RodWorld& world = {}) {
    RestState state;
    return settleSet(set, world, state);
}

TEST(RestShape, AnUnloadedArcHasTheCurvatureOfItsCircle) {
    const double radius = 0.03;
    std::vector<Vec3d> arc;
    for (const double a : {0.0, 0.1, 0.15, 0.3, 0.45, 0.7, 0.8})
        arc.push_back({radius * std::sin(a), radius * std::cos(a), 0.2});
    RodWorld weightless;
    weightless.gravity = {0, 0, 0};
    const SetGroom set = *restShapeOf(groomOf({arc}), medium(1), weightless);
    // The angle over the chord is 1/R (1 + angle^2 / 24).
    for (const Vec3f k : set.rods.naturalCurvature) {
        EXPECT_NEAR(length(k) * radius, 1, 0.0027);
        EXPECT_NEAR(k.z * radius, 0, 1e-6);
    }
    EXPECT_EQ(set.factors[0], 1);
}

TEST(RestShape, AStraightHangingStrandNeedsNoCurvature) {
    const SetGroom set =
        *restShapeOf(groomOf({straight({0.1, 0.2, 0}, {0, -0.01, 0}, 30)}), medium(1), {});
    for (const Vec3f k : set.rods.naturalCurvature)
        EXPECT_LT(length(k), 1e-3F);
    EXPECT_EQ(set.factors[0], 1);
    EXPECT_TRUE(set.unstable.empty());
}

TEST(RestShape, StraightHairBentByItsWeightIsFoundToBeStraight) {
    Rods rods;
    rods.roots = {{0, 0, 0}};
    rods.clamps = {frameAlong({1, 0, 0})};
    rods.lengths = {static_cast<float>(lengthOf(20))};
    rods.bending = {static_cast<float>(bending)};
    rods.twisting = {static_cast<float>(bending)};
    rods.weights = {static_cast<float>(weight)};
    rods.keys = {1};
    rods.offsets = {0, 60};
    std::vector<Vec3f> nodes(61);
    RestState state;
    ASSERT_TRUE(settleRods(rods, {}, state, nodes).unsettled.empty());
    Strands groom;
    groom.add(nodes, 1);
    const SetGroom set = *restShapeOf(groom, medium(1), {});
    // The hair bends to a curvature of about 6 / L.
    EXPECT_LT(length(set.rods.naturalCurvature[0]) * rods.lengths[0], 0.25F);
    for (std::size_t j = 1; j < 60; ++j)
        EXPECT_LT(length(set.rods.naturalCurvature[j]) * rods.lengths[0], 0.06F) << j;
    EXPECT_LT(length(set.rods.naturalCurvature[30]) * rods.lengths[0], 0.006F);
}

TEST(RestShape, AStandingColumnNeedsTheStiffnessOfGreenhill) {
    // A clamped column stands under its own weight up to w L^3 / EI = 7.837 (Greenhill 1881).
    for (const double gamma : {5.0, 6.2, 20.0, 200.0}) {
        const int segments = 30;
        const Strands groom =
            groomOf({straight({0, 0, 0}, {0, lengthOf(gamma) / segments, 0}, segments)});
        const SetGroom set = *restShapeOf(groom, medium(1), {});
        const double needed = std::max(1.0, 1.25 * gamma / 7.837);
        EXPECT_NEAR(set.factors[0] / needed, 1, 0.02) << gamma;
        EXPECT_EQ(set.unstable.size(), gamma > 7.837 ? 1U : 0U);
        EXPECT_NEAR(set.rods.bending[0] / (needed * bending), 1, 0.02);

        SetOptions asItIs;
        asItIs.stiffen = false;
        const SetGroom soft = *restShapeOf(groom, medium(1), {}, asItIs);
        EXPECT_EQ(soft.factors, set.factors);
        EXPECT_FLOAT_EQ(soft.rods.bending[0], static_cast<float>(bending));
        EXPECT_LT(moved(groom, settleSet(set).nodes), 1e-5);
        if (gamma > 7.837) {
            RodWorld leant;
            leant.gravity = {0.01, -1, 0};
            EXPECT_GT(moved(groom, settleSet(soft, leant).nodes), 0.1);
        }
    }
}

TEST(RestShape, WhatNoStiffnessHoldsIsSaid) {
    const Strands groom = groomOf({straight({0, 0, 0}, {0, 0.1, 0}, 20)});
    const SetGroom set = *restShapeOf(groom, medium(1), {});
    EXPECT_EQ(set.unheld, std::vector<std::uint32_t>{0});
    EXPECT_EQ(set.unstable, std::vector<std::uint32_t>{0});
    EXPECT_TRUE(std::isinf(set.factors[0]));
    EXPECT_FLOAT_EQ(set.rods.bending[0], static_cast<float>(bending));
}

class SmoothGrooms : public testing::TestWithParam<double> {};

TEST_P(SmoothGrooms, StayPut) {
    const Strands groom = smoothGroom(300, GetParam());
    const SetGroom set = *restShapeOf(groom, medium(300), {});
    EXPECT_TRUE(set.unheld.empty());
    const Settled settled = settleSet(set);
    EXPECT_TRUE(settled.report.unsettled.empty());
    EXPECT_LT(moved(groom, settled.nodes), 1e-5);
}

TEST_P(SmoothGrooms, ComeBackFromALittleMoreLoad) {
    const Strands groom = smoothGroom(300, GetParam());
    const SetGroom set = *restShapeOf(groom, medium(300), {});
    RestState state;
    settleSet(set, {}, state);
    RodWorld heavier;
    heavier.gravity = {0.005, -1.01, 0};
    const Settled there = settleSet(set, heavier, state, true);
    EXPECT_TRUE(there.report.unsettled.empty());
    EXPECT_GT(moved(groom, there.nodes), 1e-4);
    EXPECT_LT(moved(groom, there.nodes), 0.3);
    const Settled back = settleSet(set, {}, state, true);
    EXPECT_TRUE(back.report.unsettled.empty());
    EXPECT_LT(moved(groom, back.nodes), 1e-3);
}

INSTANTIATE_TEST_SUITE_P(Gammas, SmoothGrooms, testing::Values(1, 10, 100, 1000));

TEST(RestShape, ItHoldsUnderTheForcesItWasSetUnder) {
    const Strands groom = smoothGroom(50, 20);
    Force force;
    force.direction.vector = {0, 0, 1};
    force.magnitude = 0.7;
    force.within.y = {-1, 0.02};
    force.falloff.distance = 0.02;
    const std::vector<float> shares(50, 0.8F);
    RodWorld world;
    world.forces = std::span(&force, 1);
    world.rootShares = shares;
    const SetGroom set = *restShapeOf(groom, medium(50), world);
    EXPECT_LT(moved(groom, settleSet(set, world).nodes), 1e-4);
    EXPECT_GT(moved(groom, settleSet(set).nodes), 1e-2);
}

TEST(RestShape, DegenerateStrandsStayWhereTheyAre) {
    const Vec3d a = {0.1, 0.2, 0.3};
    const Strands groom = groomOf({
        {a},                                                       // a bald follicle
        {a, a, a},                                                 // no length
        {a, a + Vec3d{0, 0.01, 0}},                                // one segment
        {a, a, a + Vec3d{0.01, 0, 0}, a + Vec3d{0.02, 0.001, 0}},  // doubled root
        {a, a + Vec3d{0.01, 0, 0}, a + Vec3d{0.01, 0, 0}},         // doubled tip
        {a, a + Vec3d{0.01, 0, 0}, a, a + Vec3d{0.01, 0, 0}},      // to and fro
        {a, a + Vec3d{1e-6, 0, 0}, a + Vec3d{0.03, 0, 0}, a + Vec3d{0.03, 0.02, 0}},
        {a, a + Vec3d{0.01, 0, 0}, a + Vec3d{0.01, 0.01, 0}, a + Vec3d{0, 0.01, 0}, a},  // a square
    });
    const SetGroom set = *restShapeOf(groom, medium(groom.size()), {});
    for (const Vec3f k : set.rods.naturalCurvature)
        EXPECT_TRUE(isFinite(k));
    EXPECT_EQ(set.rods.segments(0), 0U);
    EXPECT_EQ(set.rods.segments(1), 0U);
    EXPECT_EQ(set.rods.segments(3), 2U);
    const Settled settled = settleSet(set);
    EXPECT_TRUE(settled.report.unsettled.empty());
    for (std::size_t j = 0; j < groom.nodes.size(); ++j)
        EXPECT_LT(length(settled.nodes[j] - groom.nodes[j]), 1e-6F) << j;
}

TEST(RestShape, WhatIsNotFiniteIsAProblem) {
    Strands groom = smoothGroom(3, 1);
    EXPECT_FALSE(restShapeOf(groom, medium(2), {}).ok());
    StrandMaterials limp = medium(3);
    limp.bending[1] = 0;
    EXPECT_FALSE(restShapeOf(groom, limp, {}).ok());
    groom.nodes[5].y = std::numeric_limits<float>::quiet_NaN();
    const auto set = restShapeOf(groom, medium(3), {});
    ASSERT_FALSE(set.ok());
    EXPECT_EQ(set.problems()[0].message, "strand 0 has a node that is not finite");
}

TEST(RestShape, WithoutStrengthItIsStraightHair) {
    const Strands groom = smoothGroom(40, 5);
    const SetGroom set = *restShapeOf(groom, medium(40), {});
    SetGroom none = set;
    none.rods = withStrength(set.rods, 0);
    Rods bare = none.rods;
    bare.naturalCurvature.clear();
    bare.chords.clear();
    bare.starts.clear();
    std::vector<Vec3f> nodes(bare.nodeCount());
    RestState state;
    settleRods(bare, {}, state, nodes);
    for (std::size_t j = 0; j < nodes.size(); ++j)
        nodes[j] = nodes[j] - none.offsets[j];
    const Settled settled = settleSet(none);
    for (std::size_t j = 0; j < nodes.size(); ++j)
        ASSERT_LT(length(settled.nodes[j] - nodes[j]), 1e-4 * lengthOf(5)) << j;

    const Rods half = withStrength(set.rods, 0.5);
    for (std::size_t j = 0; j < half.naturalCurvature.size(); ++j) {
        const Vec3f gap = half.naturalCurvature[j] - 0.5F * set.rods.naturalCurvature[j];
        EXPECT_LT(length(gap), 1e-6F * (1 + length(half.naturalCurvature[j])));
        EXPECT_NEAR(length(half.chords[j]) / half.segmentLengths[j], 1, 1e-6);
    }
}

TEST(RestShape, ThickerRootsCarryMore) {
    Strands groom = smoothGroom(20, 50);
    groom.diameters.resize(groom.nodes.size());
    for (std::size_t i = 0; i < groom.size(); ++i) {
        for (std::size_t j = groom.offsets[i]; j < groom.offsets[i + 1]; ++j) {
            const auto share = static_cast<float>(j - groom.offsets[i]) /
                               static_cast<float>(groom.strand(i).size() - 1);
            groom.diameters[j] = 150e-6F * (1 - share);  // to nothing at the tip
        }
    }
    const Hair hair;
    const StrandMaterials materials = materialsOf(groom, hair);
    EXPECT_NEAR(materials.bending[0] / hair.rigidity(), 16, 1e-4);
    EXPECT_NEAR(materials.weights[0] / hair.weightPerLength(), 4, 1e-4);
    EXPECT_FLOAT_EQ(materials.thickness[groom.offsets[1] - 1], 0.1F);
    const SetGroom set = *restShapeOf(groom, materials, {});
    const Settled settled = settleSet(set);
    EXPECT_TRUE(settled.report.unsettled.empty());
    EXPECT_LT(moved(groom, settled.nodes), 1e-5);
}

TEST(RestShape, TheSameFromAnyNumberOfThreads) {
    const Strands groom = smoothGroom(300, 100);
    SetOptions one;
    one.threads = 1;
    SetOptions many;
    many.threads = 7;
    const SetGroom a = *restShapeOf(groom, medium(300), {}, one);
    const SetGroom b = *restShapeOf(groom, medium(300), {}, many);
    EXPECT_EQ(a.factors, b.factors);
    EXPECT_EQ(a.rods.naturalCurvature, b.rods.naturalCurvature);
    EXPECT_EQ(a.rods.bending, b.rods.bending);
}

}  // namespace
}  // namespace kushi
