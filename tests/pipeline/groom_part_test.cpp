// SPDX-License-Identifier: Apache-2.0
//
// Grooms made elsewhere as parts of styles.
#include "fields.h"

#include <kushi/head.h>
#include <kushi/rest_shape.h>
#include <kushi/settle.h>

#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <set>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

namespace kushi {
namespace {

using testing::HasSubstr;

std::string pathOf(const std::string& name) {
    const auto* test = testing::UnitTest::GetInstance()->current_test_info();
    return testing::TempDir() + "groom-part-" + test->name() + "-" + name;
}

Style styleOf(const Strands& groom) {
    const std::string path = pathOf("g.ply");
    EXPECT_TRUE(writeGroom(groom, path).ok());
    Style style;
    style.solver.method = Method::Equilibrium;
    style.parts.resize(1);
    Part& part = style.parts[0];
    part.name = "scan";
    part.scalp.ellipsoid = headEllipsoid();
    part.groom.emplace();
    part.groom->path = path;
    part.groom->place = {"a.toml", 7, 3};
    return style;
}

Vec3d scalpPoint(double theta, double phi) {
    return headEllipsoid().point({radians(theta), radians(phi)});
}

// Strands that leave the head and hang over, with nodes at uneven steps; each has other ones.
Strands arcs(int count) {
    Strands groom;
    std::vector<Vec3f> nodes;
    for (int i = 0; i < count; ++i) {
        const double phi = 360.0 / count * i - 180;
        const Vec3d root = scalpPoint(60 + i % 3 * 15, phi);
        const Vec3d out = normalized(Vec3d{root.x, 0, root.z});
        const int segments = 9 + i % 5;
        const double bend = 0.07 + 0.004 * (i % 4);
        nodes.clear();
        for (int j = 0; j <= segments; ++j) {
            const double a = 1.6 * std::pow(static_cast<double>(j) / segments, 1.4);
            nodes.push_back(
                (root + bend * std::sin(a) * out - Vec3d{0, bend * (1 - std::cos(a)), 0})
                    .as<float>());
        }
        groom.add(nodes, 0);
    }
    groom.keys.clear();
    return groom;
}

// Helices that hang down, of 1 cm radius and 3 cm pitch.
Strands curls(int count) {
    Strands groom;
    std::vector<Vec3f> nodes;
    for (int i = 0; i < count; ++i) {
        const Vec3d root = scalpPoint(80, 30 * i);
        nodes.clear();
        for (int j = 0; j <= 60; ++j) {
            const double turn = 0.2 * j;
            const double grown = std::min(1.0, 0.25 * turn);
            nodes.push_back((root + Vec3d{0.01 * grown * std::sin(turn), -0.03 * turn / 6.283,
                                          0.01 * grown * (1 - std::cos(turn))})
                                .as<float>());
        }
        groom.add(nodes, 0);
    }
    groom.keys.clear();
    return groom;
}

SettledGroom settled(const Style& style, SettleOptions options = {}) {
    options.cacheFolder = test::fieldCache();
    auto groom = settle(style, options);
    EXPECT_TRUE(groom) << toString(groom.problems()[0]);
    if (!groom) return {};
    EXPECT_EQ(groom->report.unsettled, 0U);
    EXPECT_LE(groom->report.maxResidual.value_or(1), 1.001e-5);
    return std::move(*groom);
}

double meanTip(const Strands& groom) {
    double sum = 0;
    for (std::size_t i = 0; i < groom.size(); ++i)
        sum += groom.strand(i).back().y;
    return sum / static_cast<double>(groom.size());
}

Problem problemOf(const Style& style, const SettleOptions& options = {}) {
    const auto groom = settle(style, options);
    EXPECT_FALSE(groom);
    return groom ? Problem() : groom.problems()[0];
}

TEST(GroomPart, StaysWhereItIsWithAllItHas) {
    Strands groom = arcs(12);
    groom.add(std::vector<Vec3f>{{0, 0.12F, 0}}, 0);  // bald
    const Vec3f twice = {0.11F, 0.1F, 0};
    groom.add(std::vector<Vec3f>{{0.1F, 0.1F, 0}, twice, twice, {0.13F, 0.09F, 0.01F}}, 0);
    groom.keys.clear();
    for (std::size_t j = 0; j < groom.nodes.size(); ++j) {
        const auto number = static_cast<float>(j);
        groom.colors.push_back({0.001F * number, 0.5F, 0.25F});
        groom.diameters.push_back(60e-6F + 1e-7F * number);
        groom.transparency.push_back(0.002F * number);
    }
    SettleOptions options;
    options.segments = 5;
    options.measurePenetration = true;
    const Style style = styleOf(groom);
    const Strands file = *groomOf(style.parts[0]);
    const SettledGroom same = settled(style, options);
    EXPECT_EQ(same.strands.offsets, file.offsets);
    EXPECT_EQ(same.strands.colors, file.colors);
    EXPECT_EQ(same.strands.diameters, file.diameters);
    EXPECT_EQ(same.strands.transparency, file.transparency);
    for (std::size_t i = 0; i < file.size(); ++i) {
        const double most = 1e-4 * polylineLength(file.strand(i));
        for (std::size_t j = 0; j < file.strand(i).size(); ++j)
            EXPECT_LE(length(same.strands.strand(i)[j] - file.strand(i)[j]), most) << i << ' ' << j;
    }
    const std::set<std::uint64_t> keys(same.strands.keys.begin(), same.strands.keys.end());
    EXPECT_EQ(keys.size(), file.size());
    EXPECT_EQ(same.report.strands, 14U);
    EXPECT_EQ(same.report.segments, file.segmentCount());
    ASSERT_EQ(same.report.penetration.size(), 1U);
    EXPECT_EQ(same.report.penetration[0].found.strands, 0U);
    EXPECT_EQ(same.report.stages.size(), 4U);
    ASSERT_TRUE(same.report.set);
    EXPECT_EQ(same.report.set->unheld, 0U);
}

TEST(GroomPart, HasTheStylesColourAndDiameterWhereItsFileHasNone) {
    Style style = styleOf(arcs(3));
    style.parts[0].hair.diameter = 90e-6;
    style.parts[0].hair.taper = 0.5;
    style.parts[0].hair.color = {1, 0, 0};
    const SettledGroom groom = settled(style);
    EXPECT_FLOAT_EQ(groom.strands.diameters[0], 90e-6F);
    EXPECT_NEAR(groom.strands.diameters[groom.strands.offsets[1] - 1], 45e-6, 1e-9);
    EXPECT_GT(groom.strands.colors[0].r, 0.3F);
    EXPECT_EQ(groom.strands.colors[0].g, 0);
    const Strands file = *groomOf(style.parts[0]);
    EXPECT_LT(length(groom.strands.nodes[5] - file.nodes[5]), 1e-5F);
}

TEST(GroomPart, MayBeClumpedAndFlyAway) {
    Style style = styleOf(arcs(120));
    const SettledGroom before = settled(style);
    style.parts[0].hair.clump.amount = 0.6;
    style.parts[0].hair.clump.size = 0.03;
    style.parts[0].hair.flyaway.share = 0.1;
    const SettledGroom after = settled(style);
    EXPECT_GT(after.report.clumps, 10U);
    EXPECT_GT(after.report.flyaways, 2U);
    EXPECT_EQ(after.strands.offsets, before.strands.offsets);
    EXPECT_EQ(after.strands.colors, before.strands.colors);
    EXPECT_NE(after.strands.nodes, before.strands.nodes);
    for (std::size_t i = 0; i < after.strands.size(); ++i)
        EXPECT_EQ(after.strands.strand(i)[0], before.strands.strand(i)[0]);
}

TEST(GroomPart, TurnedUpsideDownItFallsTheOtherWay) {
    Style style = styleOf(arcs(12));
    const double before = meanTip(settled(style).strands);
    style.gravity = {0, 3, 0};
    EXPECT_GT(meanTip(settled(style).strands), before + 0.05);
}

TEST(GroomPart, DenserHairFallsAndStifferHairSprings) {
    Style style = styleOf(arcs(12));
    const double before = meanTip(settled(style).strands);
    Style wet = style;
    wet.parts[0].hair.density = 2640;
    Style heavy = style;
    heavy.gravity = {0, -2, 0};
    EXPECT_LT(meanTip(settled(wet).strands), before - 0.005);
    // Twice as dense under one g is as dense under two.
    EXPECT_NEAR(meanTip(settled(wet).strands), meanTip(settled(heavy).strands), 1e-4);
    style.parts[0].hair.stiffness = 2;
    EXPECT_GT(meanTip(settled(style).strands), before + 0.002);
}

// Against the rods themselves: straight, as long, from the same clamps, of hair as it is.
TEST(GroomPart, WithoutItsSetItIsStraightHairOfItsLength) {
    const Strands groom = arcs(12);
    Style style = styleOf(groom);
    const SettledGroom held = settled(style);
    style.parts[0].hair.set = 0;
    const SettledGroom fallen = settled(style);

    Rods rods = restShapeOf(groom, materialsOf(groom, Hair()), {})->rods;
    rods.bending.assign(rods.size(), static_cast<float>(Hair().rigidity()));
    rods.naturalCurvature.clear();
    rods.chords.clear();
    rods.starts.clear();
    RestState state;
    std::vector<Vec3f> nodes(rods.nodeCount());
    settleRods(rods, {}, state, nodes);
    float most = 0;
    for (std::size_t j = 0; j < nodes.size(); ++j) {
        EXPECT_LT(length(fallen.strands.nodes[j] - nodes[j]), 2e-4F * 0.1F);
        most = std::max(most, length(held.strands.nodes[j] - nodes[j]));
    }
    EXPECT_GT(most, 0.01F);
}

// A column of hair that stands is stiffened to hold; what holds it goes with its set.
TEST(GroomPart, WhatWasStiffenedToHoldFallsWithItsSet) {
    Strands groom;
    std::vector<Vec3f> nodes;
    for (int j = 0; j <= 20; ++j)
        nodes.push_back({1e-4F * static_cast<float>(j), 0.12F + 0.01F * static_cast<float>(j), 0});
    groom.add(nodes, 0);
    groom.keys.clear();
    Style style = styleOf(groom);
    const SettledGroom standing = settled(style);
    EXPECT_NEAR(standing.strands.nodes.back().y, 0.32, 1e-4);
    EXPECT_EQ(standing.report.set->unstable, 1U);
    EXPECT_EQ(standing.report.set->stiffened, 1U);
    EXPECT_GT(standing.report.set->stiffenedMost, 5);
    EXPECT_EQ(standing.report.set->stiffenedMost, standing.report.set->stiffenedMedian);
    style.parts[0].hair.set = 0;
    EXPECT_LT(settled(style).strands.nodes.back().y, 0.1F);
}

TEST(GroomPart, ForcesPullTheStrandsOfTheirRootsWithinTheirBoxes) {
    Style style = styleOf(arcs(12));
    const SettledGroom before = settled(style);
    Force force;
    force.roots = {{{}, {radians(1), radians(179)}}};  // the right half
    force.direction.vector = {0, 1, 0};
    force.magnitude = 0.5;
    style.parts[0].forces = {force};
    const SettledGroom after = settled(style);
    int lifted = 0;
    for (std::size_t i = 0; i < 12; ++i) {
        const Vec3f root = before.strands.strand(i)[0];
        const float rise = after.strands.strand(i).back().y - before.strands.strand(i).back().y;
        if (root.z > 0.01F) {
            EXPECT_GT(rise, 0.002F) << i;
            ++lifted;
        } else if (root.z < -0.01F) {
            EXPECT_LT(std::abs(rise), 1e-4F) << i;
        }
    }
    EXPECT_GE(lifted, 4);
    style.parts[0].forces[0].within.y = {1, 2};  // a metre above the head
    EXPECT_NEAR(meanTip(settled(style).strands), meanTip(before.strands), 1e-5);
}

// Without the weight of what is cut off a curl is drawn out less.
TEST(GroomPart, ACurlThatIsCutInHalfSpringsUp) {
    Style style = styleOf(curls(12));
    const double whole = polylineLength(settled(style).strands.strand(0));
    Cut cut;
    cut.keep = {{0, whole / 2}};
    cut.mode = CutMode::Hide;
    style.parts[0].cuts = {cut};
    const SettledGroom hidden = settled(style);
    style.parts[0].cuts[0].mode = CutMode::Settle;
    const SettledGroom sprung = settled(style);
    ASSERT_EQ(sprung.strands.offsets, hidden.strands.offsets);
    for (std::size_t i = 0; i < 12; ++i) {
        EXPECT_NEAR(polylineLength(hidden.strands.strand(i)), whole / 2, 1e-6);
        EXPECT_NEAR(polylineLength(sprung.strands.strand(i)), whole / 2, 1e-6);
        EXPECT_GT(sprung.strands.strand(i).back().y, hidden.strands.strand(i).back().y + 0.003F);
    }
    EXPECT_EQ(sprung.strands.diameters.size(), sprung.strands.nodes.size());
}

// In no field there is nothing to spring from: the shorter hair lies along the whole.
TEST(GroomPart, WithoutLoadsACutChangesNothingAbove) {
    Style style = styleOf(curls(6));
    style.gravity = {0, 0, 0};
    const SettledGroom whole = settled(style);
    Cut cut;
    cut.keep = {{0, 0.071}};
    style.parts[0].cuts = {cut};
    const SettledGroom shorter = settled(style);
    for (std::size_t i = 0; i < 6; ++i) {
        const auto nodes = shorter.strands.strand(i);
        EXPECT_NEAR(polylineLength(nodes), 0.071, 1e-6);
        for (std::size_t j = 0; j + 1 < nodes.size(); ++j)
            EXPECT_LT(length(nodes[j] - whole.strands.strand(i)[j]), 2e-4F) << j;
    }
}

TEST(GroomPart, CutsFollowOneAnother) {
    Style style = styleOf(curls(6));
    Cut hide;
    hide.keep = {{0, 0.1}};
    hide.mode = CutMode::Hide;
    Cut settleMore;
    settleMore.keep = {{0, 0.06}};
    Cut longer;
    longer.keep = {{0, 0.08}};
    style.parts[0].cuts = {settleMore};
    const SettledGroom once = settled(style);
    style.parts[0].cuts = {hide, settleMore, longer, hide};
    const SettledGroom twice = settled(style);
    EXPECT_EQ(twice.strands.nodes, once.strands.nodes);
    style.parts[0].cuts = {longer, settleMore};
    const SettledGroom again = settled(style);
    for (std::size_t j = 0; j < once.strands.nodes.size(); ++j)
        EXPECT_LT(length(again.strands.nodes[j] - once.strands.nodes[j]), 1e-5F);

    Cut above;
    above.below = 0.5;
    style.parts[0].cuts = {above};
    EXPECT_EQ(settled(style).strands.size(), 0U);
}

TEST(GroomPart, ACutEndHasTheColourOfItsPlace) {
    Strands groom = arcs(4);
    for (std::size_t i = 0; i < groom.size(); ++i) {
        double walked = 0;
        const auto nodes = groom.strand(i);
        for (std::size_t j = 0; j < nodes.size(); ++j) {
            if (j > 0) walked += length(nodes[j] - nodes[j - 1]);
            groom.colors.push_back({static_cast<float>(walked), 0, 0});
        }
    }
    Style style = styleOf(groom);
    Cut cut;
    cut.keep = {{0, 0.0567}};
    for (const CutMode mode : {CutMode::Hide, CutMode::Settle}) {
        cut.mode = mode;
        style.parts[0].cuts = {cut};
        const Strands strands = settled(style).strands;
        for (std::size_t i = 0; i < 4; ++i)
            EXPECT_NEAR(strands.colors[strands.offsets[i + 1] - 1].r, 0.0567, 0.003);
    }
}

TEST(GroomPart, DoesNotDependOnTheNumberOfThreads) {
    Style style = styleOf(curls(40));
    style.gravity = {0.5, -1, 0.5};
    style.parts[0].hair.set = 0.7;
    Cut cut;
    cut.below = 0;
    style.parts[0].cuts = {cut};
    SettleOptions options;
    options.threads = 1;
    const SettledGroom one = settled(style, options);
    for (const int threads : {2, 8}) {
        options.threads = threads;
        EXPECT_EQ(settled(style, options).strands.nodes, one.strands.nodes) << threads;
    }
}

TEST(GroomPart, OfAPreviewIsThatOfTheWholeAndNeverMore) {
    Style style = styleOf(arcs(40));
    style.gravity = {0, -2, 0};
    const SettledGroom whole = settled(style);
    SettleOptions options;
    options.count = 10;
    const SettledGroom some = settled(style, options);
    ASSERT_EQ(some.strands.size(), 10U);
    for (std::size_t i = 0; i < 10; ++i) {
        const auto found = std::ranges::find(whole.strands.keys, some.strands.keys[i]) -
                           whole.strands.keys.begin();
        ASSERT_LT(found, 40);
        const auto same = whole.strands.strand(static_cast<std::size_t>(found));
        EXPECT_LT(length(same.back() - some.strands.strand(i).back()), 1e-5F);
    }
    options.count = 1000;
    EXPECT_EQ(settled(style, options).strands.size(), 40U);
}

TEST(GroomPart, StandsBesideHairThatGrows) {
    Strands groom = arcs(10);
    groom.transparency.assign(groom.nodes.size(), 0.5F);
    Style style = styleOf(groom);
    style.headCollides = false;  // hair grows where the neck is
    Part grown;
    grown.name = "grown";
    grown.scalp.ellipsoid = headEllipsoid();
    grown.scalp.count = 30;
    grown.hair.length = 0.1;
    style.parts.insert(style.parts.begin(), grown);
    const SettledGroom both = settled(style);
    ASSERT_EQ(both.strands.size(), 40U);
    EXPECT_EQ(both.innerEnds.size(), 40U);
    ASSERT_EQ(both.strands.transparency.size(), both.strands.nodes.size());
    EXPECT_EQ(both.strands.transparency.front(), 0);
    EXPECT_EQ(both.strands.transparency.back(), 0.5F);
    EXPECT_EQ(both.strands.colors.size(), both.strands.nodes.size());
    SettleOptions options;
    options.count = 20;
    options.measurePenetration = true;
    const SettledGroom half = settled(style, options);
    EXPECT_EQ(half.strands.size(), 20U);
    EXPECT_EQ(half.report.penetration.size(), 1U);
}

TEST(GroomPart, HasInnerPiecesOnlyWhereTheHeadHidesThem) {
    Strands groom = arcs(4);
    groom.add(std::vector<Vec3f>{{0, 0.5F, 0}, {0.01F, 0.49F, 0}}, 0);
    groom.keys.clear();
    const SettledGroom settledGroom = settled(styleOf(groom));
    for (std::size_t i = 0; i < 4; ++i) {
        const Vec3f root = settledGroom.strands.strand(i)[0];
        EXPECT_NEAR(length(settledGroom.innerEnds[i] - root), 0.02F, 1e-6F);
        EXPECT_LT(length(settledGroom.innerEnds[i]), length(root));
    }
    EXPECT_EQ(settledGroom.innerEnds[4], settledGroom.strands.strand(4)[0]);
    const Strands drawn = withInnerPieces(settledGroom);
    EXPECT_EQ(drawn.strand(0).size(), settledGroom.strands.strand(0).size() + 1);
    EXPECT_EQ(drawn.strand(4).size(), 2U);
    EXPECT_EQ(drawn.colors.size(), drawn.nodes.size());
}

TEST(GroomPart, WhatIsWrongIsSaidWhereTheStyleNamesIt) {
    Style style = styleOf(arcs(3));
    const auto expectAtPlace = [](const Problem& problem, const std::string& message) {
        EXPECT_EQ(problem.file, "a.toml");
        EXPECT_EQ(problem.line, 7);
        EXPECT_EQ(problem.column, 3);
        EXPECT_THAT(problem.message, HasSubstr(message));
    };
    SettleOptions walk;
    walk.method = Method::Cantilever;
    EXPECT_THAT(problemOf(style, walk).message, HasSubstr("--method equilibrium"));

    Style missing = style;
    missing.parts[0].groom->path = pathOf("none.hair");
    expectAtPlace(problemOf(missing), "none.hair: ");
    expectAtPlace(groomOf(missing.parts[0]).problems()[0], "No such file");

    missing.parts[0].groom->path = pathOf("bad.obj");
    std::ofstream(missing.parts[0].groom->path) << "v 0 0 0\nv 0 nan 0\nl 1 2\n";
    expectAtPlace(problemOf(missing), "bad.obj:2");

    EXPECT_TRUE(writeGroom(Strands(), pathOf("empty.ply")).ok());
    missing.parts[0].groom->path = pathOf("empty.ply");
    expectAtPlace(problemOf(missing), "has no strands");

    Strands thick = arcs(3);
    thick.diameters.assign(thick.nodes.size(), 80e-6F);
    style = styleOf(thick);
    style.parts[0].hair.taper = 0.5;
    expectAtPlace(problemOf(style), "'taper'");
}

// Grooms made by others, which are not part of Kushi; KUSHI_TEST_DATA names their folder.
TEST(GroomPart, OfARealWigHoldsAndFollows) {
    const char* folder = std::getenv("KUSHI_TEST_DATA");
    if (folder == nullptr) GTEST_SKIP() << "KUSHI_TEST_DATA names no folder of sample grooms";
    const std::string path = std::filesystem::path(folder) / "Bangs_100_binary.ply";
    if (!std::filesystem::exists(path)) GTEST_SKIP() << path << " is not there";
    Style style = styleOf(arcs(1));
    GroomSource& source = *style.parts[0].groom;
    source.path = path;
    source.placement.unit = 0.001;
    source.placement.up = {1, 0, 0};
    source.placement.front = {0, -1, 0};
    source.placement.offset = {0.127, -0.12, -0.118};
    const Strands file = *groomOf(style.parts[0]);
    const SettledGroom onOurHead = settled(style);
    EXPECT_GT(onOurHead.report.pushedOut, 0U);
    EXPECT_EQ(onOurHead.report.stuck, 0U);
    style.headCollides = false;  // it was made for another
    const SettledGroom same = settled(style);
    ASSERT_EQ(same.strands.offsets, file.offsets);
    for (std::size_t i = 0; i < file.size(); ++i) {
        const double most = 1e-4 * polylineLength(file.strand(i));
        for (std::size_t j = 0; j < file.strand(i).size(); ++j)
            EXPECT_LE(length(same.strands.strand(i)[j] - file.strand(i)[j]), most);
    }
    style.gravity = {0, 1, 0};
    Cut cut;
    cut.keep = {{0, 0.08}};
    style.parts[0].cuts = {cut};
    const SettledGroom turned = settled(style);
    EXPECT_GT(meanTip(turned.strands), meanTip(same.strands) + 0.01);
    for (std::size_t i = 0; i < turned.strands.size(); ++i)
        EXPECT_LT(polylineLength(turned.strands.strand(i)), 0.08 + 1e-6);
}

}  // namespace
}  // namespace kushi
