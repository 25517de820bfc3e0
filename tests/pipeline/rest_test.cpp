// SPDX-License-Identifier: Apache-2.0
#include "pipeline/grow.h"
#include "pipeline/head_of_hair.h"

#include <kushi/settle.h>

#include <cmath>

#include <gtest/gtest.h>

namespace kushi {
namespace {

Style style(int count) {
    return headOfHair(count, 24, 0.15);
}

SettleOptions threads(int count) {
    SettleOptions options;
    options.threads = count;
    return options;
}

SettleOptions preview(std::size_t count) {
    SettleOptions options;
    options.count = count;
    return options;
}

SettleOptions walk() {
    SettleOptions options;
    options.method = Method::Cantilever;
    return options;
}

RodWorld weightlessness() {
    RodWorld world;
    world.gravity = {0, 0, 0};
    return world;
}

SettledGroom settled(const Style& style, const SettleOptions& options = {}) {
    auto groom = settle(style, options);
    EXPECT_TRUE(groom) << toString(groom.problems()[0]);
    EXPECT_EQ(groom->report.unsettled, 0);
    EXPECT_LE(groom->report.maxResidual.value_or(1), 1.001e-5);
    return *groom;
}

double lowest(const SettledGroom& groom) {
    return boundsOf(groom.strands.nodes).low.y;
}

TEST(HairAtRest, KeepsItsLengthAndStaysOutsideOfTheHead) {
    const Style hair = style(800);
    const SettledGroom groom = settled(hair);
    ASSERT_EQ(groom.strands.size(), 800);
    for (std::size_t i = 0; i < groom.strands.size(); ++i) {
        EXPECT_NEAR(polylineLength(groom.strands.strand(i)), 0.15, 1e-6);
        for (const Vec3f node : groom.strands.strand(i))
            EXPECT_LT(hair.parts[0].scalp.ellipsoid.depth(node.as<double>()), 1e-5);
    }
}

TEST(HairAtRest, DoesNotDependOnTheNumberOfThreads) {
    Style hair = style(700);
    hair.parts[0].hair.curl = Curl{0.004, 0.03, 0.15};
    const auto one = settle(hair, threads(1));
    for (const int count : {2, 8}) {
        const auto more = settle(hair, threads(count));
        EXPECT_EQ(one->strands.nodes, more->strands.nodes) << count;
        EXPECT_EQ(one->report.maxResidual, more->report.maxResidual) << count;
    }
}

// Of the same hairs, whatever else there is: a preview shows what the whole will be.
TEST(HairAtRest, OfAPreviewIsThatOfTheWhole) {
    const Style hair = style(600);
    const SettledGroom whole = settled(hair);
    const SettledGroom some = settled(hair, preview(60));
    std::size_t found = 0;
    for (std::size_t i = 0; i < some.strands.size(); ++i) {
        for (std::size_t k = 0; k < whole.strands.size(); ++k) {
            if (whole.strands.keys[k] != some.strands.keys[i]) continue;
            ++found;
            EXPECT_LT(length(whole.strands.strand(k).back() - some.strands.strand(i).back()), 1e-5);
        }
    }
    EXPECT_EQ(found, 60);
}

TEST(HairAtRest, IsDrawnBySteadyForcesInTheirBoxes) {
    Style hair = style(300);
    const double before = boundsOf(settled(hair).strands.nodes).low.z;
    Force force;
    force.direction.vector = {0, 0, 1};
    force.magnitude = 1;
    force.falloff.distance = 0.03;
    hair.parts[0].forces = {force};
    EXPECT_GT(boundsOf(settled(hair).strands.nodes).low.z, before + 0.01);
    hair.parts[0].forces[0].within.y = {1, 2};  // a metre above the head
    EXPECT_NEAR(boundsOf(settled(hair).strands.nodes).low.z, before, 1e-4);
}

// Shorter hair is lighter: it rises when it is settled anew, and not when the rest is hidden.
TEST(HairAtRest, SpringsUpWhereItIsCut) {
    Style hair = style(300);
    hair.solver.segments = 48;
    hair.parts[0].hair.length = 0.25;
    hair.parts[0].hair.curl = Curl{0.008, 0.03, 0.15};
    Cut cut;
    cut.keep = {{0, 0.12}};
    cut.mode = CutMode::Hide;
    hair.parts[0].cuts = {cut};
    const double hidden = lowest(settled(hair));
    hair.parts[0].cuts[0].mode = CutMode::Settle;
    EXPECT_GT(lowest(settled(hair)), hidden + 0.005);
}

TEST(HairAtRest, TapersToItsTip) {
    Style hair = style(20);
    hair.parts[0].hair.taper = 0.5;
    const SettledGroom groom = settled(hair);
    EXPECT_FLOAT_EQ(groom.strands.diameters.front(), 75e-6F);
    EXPECT_NEAR(groom.strands.diameters.back(), 37.5e-6, 1e-9);
}

TEST(HairAtRest, NeedsSeveralSegmentsForATurnOfACurl) {
    Style hair = style(20);
    hair.parts[0].hair.curl = Curl{0.002, 0.005, 0.15};
    const auto groom = settle(hair);
    ASSERT_FALSE(groom);
    EXPECT_NE(groom.problems()[0].message.find("give [solver] segments = "), std::string::npos);
}

TEST(HairAtRest, IsNotForTheWalkWhereItCurls) {
    Style hair = style(20);
    hair.parts[0].hair.wave = Wave{0.01, 0.05, 0.15};
    const auto groom = settle(hair, walk());
    ASSERT_FALSE(groom);
    EXPECT_NE(groom.problems()[0].message.find("equilibrium"), std::string::npos);
}

Rods grown(const Style& style) {
    const auto follicles = plant(style.parts[0].scalp, 1);
    std::vector<std::uint32_t> which(follicles->size());
    for (std::uint32_t i = 0; i < which.size(); ++i)
        which[i] = i;
    return grow(style.parts[0], *follicles, uncut(style.parts[0].hair, *follicles, 96), which,
                style.solver.grading);
}

std::vector<Vec3f> weightless(const Rods& rods) {
    std::vector<Vec3f> nodes(rods.nodeCount());
    RestState state;
    settleRods(rods, weightlessness(), state, nodes);
    return nodes;
}

// A helix of radius r and pitch p rises p for 2 pi sqrt(r^2 + (p / 2 pi)^2) of its length.
TEST(GrownHair, WindsAboutItsGrowthDirection) {
    Style hair = style(20);
    hair.parts[0].hair.curl = Curl{0.006, 0.02, 0};
    const Rods rods = grown(hair);
    const std::vector<Vec3f> nodes = weightless(rods);
    const double rise = 0.02 / (2 * std::numbers::pi);
    const double share = rise / std::hypot(0.006, rise);
    for (std::size_t i = 0; i < rods.size(); ++i) {
        const Vec3d root = rods.roots[i].as<double>();
        const Vec3d out = hair.parts[0].scalp.ellipsoid.normal(root);
        const Vec3d tip = nodes[rods.firstNode(i) + 96].as<double>() - root;
        EXPECT_NEAR(dot(tip, out), share * 0.15, 1e-4);
        EXPECT_LT(length(tip - dot(tip, out) * out), 2 * 0.006 + 1e-4);
    }
}

TEST(GrownHair, WavesAboutItsGrowthDirection) {
    Style hair = style(20);
    hair.parts[0].hair.wave = Wave{0.01, 0.05, 0};
    const Rods rods = grown(hair);
    const std::vector<Vec3f> nodes = weightless(rods);
    for (std::size_t i = 0; i < rods.size(); ++i) {
        const Vec3d out = hair.parts[0].scalp.ellipsoid.normal(rods.roots[i].as<double>());
        double least = 1;
        double most = 0;
        Vec3d across{};
        for (std::size_t j = 0; j <= 96; ++j) {
            const Vec3d from = (nodes[rods.firstNode(i) + j] - rods.roots[i]).as<double>();
            const Vec3d side = from - dot(from, out) * out;
            if (length(across) == 0 && length(side) > 1e-3) across = normalized(side);
            least = std::min(least, dot(side, across));
            most = std::max(most, dot(side, across));
        }
        EXPECT_NEAR(most - least, 0.02, 4e-4);
    }
}

TEST(GrownHair, IsFinestAtTheRootWhereItIsGraded) {
    Style hair = style(5);
    hair.solver.grading = 1.5;
    const Rods rods = grown(hair);
    EXPECT_NEAR(rods.segmentLengths[0], 0.15 * std::pow(1.0 / 96, 1.5), 1e-8);
    double sum = 0;
    for (std::size_t j = 0; j < 96; ++j)
        sum += rods.segmentLengths[j];
    EXPECT_NEAR(sum, 0.15, 1e-6);
}

}  // namespace
}  // namespace kushi
