// SPDX-License-Identifier: Apache-2.0
#include <kushi/settle.h>

#include <algorithm>
#include <set>

#include <gtest/gtest.h>

namespace kushi {
namespace {

// A small head of hair: one part, gravity alone, and nothing but the ellipsoid in its way.
Style plain(int count) {
    Style style;
    style.headCollides = false;
    Part part;
    part.name = "hair";
    part.scalp.ellipsoid = {{}, {0.105, 0.125, 0.085}, radians(20)};
    part.scalp.count = count;
    part.scalp.regions = {{{0, radians(100)}, {}}};
    part.hair.length = 0.25;
    style.parts = {part};
    return style;
}

SettledGroom settled(const Style& style, const SettleOptions& options = {}) {
    Result<SettledGroom> groom = settle(style, options);
    EXPECT_TRUE(groom.ok());
    return std::move(*groom);
}

bool sameBytes(const Strands& a, const Strands& b) {
    return a.nodes == b.nodes && a.offsets == b.offsets && a.keys == b.keys &&
           a.diameters == b.diameters;
}

TEST(HeadOf, IsTheMannequinNoneOrAFiles) {
    Style style = plain(1);
    Result<Mesh> head = headOf(style);
    ASSERT_TRUE(head.ok());
    EXPECT_GT(head->triangles.size(), 1000U);
    style.headMesh = "none";
    head = headOf(style);
    ASSERT_TRUE(head.ok());
    EXPECT_TRUE(head->triangles.empty());
    style.headMesh = "no/such/head.obj";
    head = headOf(style);
    ASSERT_FALSE(head.ok());
    EXPECT_EQ(head.problems().front().file, "no/such/head.obj");
}

TEST(Settle, GivesTheSameBytesFromAnyNumberOfThreads) {
    Style style = plain(2000);
    style.parts[0].hair.lengthVariation = 0.1;
    Force force;
    force.direction.radial = true;
    force.magnitude = 0.3;
    style.parts[0].forces = {force};
    Cut cut;
    cut.below = -0.05;
    style.parts[0].cuts = {cut};
    SettleOptions options;
    options.threads = 1;
    const SettledGroom one = settled(style, options);
    for (const int threads : {2, 8}) {
        options.threads = threads;
        const SettledGroom many = settled(style, options);
        EXPECT_TRUE(sameBytes(one.strands, many.strands));
        EXPECT_EQ(one.innerEnds, many.innerEnds);
    }
}

TEST(Settle, KeepsEveryStrandsLength) {
    Style style = plain(500);
    style.parts[0].hair.lengthVariation = 0.1;
    const SettledGroom groom = settled(style);
    double shortest = 1;
    double longest = 0;
    for (std::size_t i = 0; i < groom.strands.size(); ++i) {
        const double l = polylineLength(groom.strands.strand(i));
        shortest = std::min(shortest, l);
        longest = std::max(longest, l);
    }
    EXPECT_GE(shortest, 0.25 * 0.9 * (1 - 1e-6));
    EXPECT_LT(shortest, 0.25 * 0.91);
    EXPECT_LE(longest, 0.25 * 1.1 * (1 + 1e-6));
    EXPECT_GT(longest, 0.25 * 1.09);

    style.parts[0].hair.lengthVariation = 0;
    const SettledGroom even = settled(style);
    for (std::size_t i = 0; i < even.strands.size(); ++i) {
        ASSERT_NEAR(polylineLength(even.strands.strand(i)) / 0.25, 1, 1e-6);
    }
}

TEST(Settle, APreviewShowsTheSameHairs) {
    const SettledGroom all = settled(plain(3000));
    SettleOptions options;
    options.count = 300;
    const SettledGroom few = settled(plain(3000), options);
    ASSERT_EQ(few.strands.size(), 300U);
    std::size_t at = 0;
    for (std::size_t i = 0; i < few.strands.size(); ++i) {
        while (all.strands.keys[at] != few.strands.keys[i])
            ++at;
        ASSERT_TRUE(std::ranges::equal(all.strands.strand(at), few.strands.strand(i)));
    }
}

TEST(Settle, ACountAboveTheStylesPlantsAnew) {
    SettleOptions options;
    options.count = 1500;
    EXPECT_NEAR(static_cast<double>(settled(plain(1000), options).strands.size()), 1500,
                0.005 * 1500);
}

TEST(Settle, PartsShareACountByWhatTheyHave) {
    Style style = plain(300);
    style.parts.push_back(style.parts[0]);
    style.parts[1].name = "tail";
    style.parts[1].scalp.count = 100;
    style.parts[1].hair.length = 0.1;
    SettleOptions options;
    options.count = 80;
    const SettledGroom groom = settled(style, options);
    ASSERT_EQ(groom.strands.size(), 80U);
    std::size_t shortOnes = 0;
    for (std::size_t i = 0; i < 80; ++i)
        shortOnes += polylineLength(groom.strands.strand(i)) < 0.2 ? 1 : 0;
    EXPECT_EQ(shortOnes, 20U);
}

// Without falloff the cut ends at the edge of its roots; with it, hair gets longer across the edge.
TEST(Settle, ACutFadesAcrossTheEdgeOfItsRoots) {
    Style style = plain(4000);
    style.gravity = {};
    Cut cut;
    cut.keep = {{0, 0.05}};
    cut.mode = CutMode::Hide;
    cut.roots = {{{}, {radians(-40), radians(40)}}};
    style.parts[0].cuts = {cut};
    const auto shareCut = [&](double low, double high) {
        const Ellipsoid& ellipsoid = style.parts[0].scalp.ellipsoid;
        const SettledGroom groom = settled(style);
        double sum = 0;
        int count = 0;
        for (std::size_t i = 0; i < groom.strands.size(); ++i) {
            const auto nodes = groom.strands.strand(i);
            const double phi = degrees(ellipsoid.angles(nodes[0].as<double>()).phi);
            if (phi < low || phi > high) continue;
            sum += (0.25 - polylineLength(nodes)) / 0.2;
            ++count;
        }
        return sum / count;
    };
    EXPECT_NEAR(shareCut(30, 39), 1, 1e-4);
    EXPECT_NEAR(shareCut(41, 50), 0, 1e-4);

    style.parts[0].cuts[0].falloff.angle = radians(20);
    EXPECT_NEAR(shareCut(0, 29), 1, 1e-4);
    EXPECT_NEAR(shareCut(39, 41), 0.5, 0.05);
    EXPECT_GT(shareCut(33, 36), shareCut(44, 47) + 0.4);
    EXPECT_NEAR(shareCut(51, 60), 0, 1e-4);
}

// Hide keeps the shape and only ends it; at the height exactly, but for strands that never reach
// it.
TEST(Settle, AHideCutShowsLessOfTheSameShape) {
    Style style = plain(800);
    const SettledGroom whole = settled(style);
    Cut cut;
    cut.mode = CutMode::Hide;
    cut.below = 0.02;
    style.parts[0].cuts = {cut};
    const SettledGroom hidden = settled(style);

    std::size_t clippedOnes = 0;
    std::size_t at = 0;
    for (std::size_t i = 0; i < hidden.strands.size(); ++i) {
        while (whole.strands.keys[at] != hidden.strands.keys[i])
            ++at;
        const auto before = whole.strands.strand(at);
        const auto after = hidden.strands.strand(i);
        for (std::size_t k = 0; k + 1 < after.size(); ++k)
            ASSERT_EQ(after[k], before[k]);
        for (const Vec3f node : after)
            ASSERT_GE(node.y, 0.02F - 1e-8F);
        if (after.size() == before.size() && after.back() == before.back()) continue;
        ASSERT_NEAR(after.back().y, 0.02, 1e-8);
        ++clippedOnes;
    }
    EXPECT_GT(clippedOnes, 300U);
    for (std::size_t i = 0; i < whole.strands.size(); ++i) {
        const bool leftOut = std::find(hidden.strands.keys.begin(), hidden.strands.keys.end(),
                                       whole.strands.keys[i]) == hidden.strands.keys.end();
        EXPECT_EQ(leftOut, whole.strands.strand(i)[0].y < 0.02F);
    }
}

TEST(Settle, ASettleCutBendsTheShorterHairAnew) {
    Style style = plain(400);
    const SettledGroom whole = settled(style);
    Cut cut;
    cut.keep = {{0, 0.1}};
    style.parts[0].cuts = {cut};
    const SettledGroom cutHair = settled(style);

    // The same as hair that grew to 10 cm: ceil(0.1 / (0.25 / 24)) = 10 segments.
    Style grown = plain(400);
    grown.parts[0].hair.length = 0.1;
    grown.solver.segments = 10;
    const SettledGroom shortHair = settled(grown);
    ASSERT_EQ(cutHair.strands.nodes.size(), shortHair.strands.nodes.size());
    for (std::size_t i = 0; i < shortHair.strands.nodes.size(); ++i) {
        ASSERT_LT(length(cutHair.strands.nodes[i] - shortHair.strands.nodes[i]), 1e-6F);
    }
    // Less weight bends it less.
    EXPECT_NE(cutHair.strands.nodes[5], whole.strands.nodes[5]);
}

TEST(Settle, CutsApplyInTheOrderWritten) {
    Style style = plain(200);
    Cut hide;
    hide.mode = CutMode::Hide;
    hide.keep = {{0, 0.05}};
    Cut shorten;
    shorten.keep = {{0, 0.1}};
    // Hidden to 5 cm, it no longer reaches the second cut.
    style.parts[0].cuts = {hide, shorten};
    const SettledGroom hiddenFirst = settled(style);
    style.parts[0].cuts = {hide};
    EXPECT_TRUE(sameBytes(hiddenFirst.strands, settled(style).strands));
    // Cut to 10 cm and bent anew, then hidden to 5.
    style.parts[0].cuts = {shorten, hide};
    EXPECT_FALSE(sameBytes(hiddenFirst.strands, settled(style).strands));
}

TEST(Settle, ReportsCountsTimesAndPenetration) {
    SettleOptions options;
    options.measurePenetration = true;
    double last = 0;
    options.threads = 1;
    options.progress = [&](double share) {
        EXPECT_GT(share, last);
        last = share;
    };
    const SettledGroom groom = settled(plain(1000), options);
    EXPECT_EQ(last, 1);
    EXPECT_EQ(groom.report.strands, groom.strands.size());
    EXPECT_EQ(groom.report.segments, groom.strands.segmentCount());
    ASSERT_EQ(groom.report.stages.size(), 2U);
    ASSERT_EQ(groom.report.penetration.size(), 1U);
    // Nodes are outside; a chord of a segment d dips at most about d^2 / (8 r) below them.
    EXPECT_GT(groom.report.penetration[0].found.deepest, 0);
    EXPECT_LT(groom.report.penetration[0].found.deepest, 0.002);
}

// Every strand's colour is the hair's, within the variation; the same from root to tip but for the
// darker first 3 cm.
TEST(Settle, ColoursVaryByStrandAndDarkenTowardsTheRoot) {
    Style style = plain(300);
    style.parts[0].hair.color = {0.4F, 0.2F, 0.1F};
    style.parts[0].hair.variation = 0.2;
    const Strands strands = settled(style).strands;
    ASSERT_EQ(strands.colors.size(), strands.nodes.size());
    float darkest = 1;
    float lightest = 0;
    for (std::size_t i = 0; i < strands.size(); ++i) {
        const Rgb root = strands.colors[strands.offsets[i]];
        const Rgb tip = strands.colors[strands.offsets[i + 1] - 1];
        EXPECT_NEAR(tip.g / tip.r, 0.5, 1e-5);
        EXPECT_NEAR(root.r / tip.r, 0.65, 1e-5);
        darkest = std::min(darkest, tip.r / 0.4F);
        lightest = std::max(lightest, tip.r / 0.4F);
    }
    EXPECT_GE(darkest, 0.8F - 1e-5F);
    EXPECT_LT(darkest, 0.83F);
    EXPECT_LE(lightest, 1.2F + 1e-5F);
    EXPECT_GT(lightest, 1.17F);
}

TEST(Settle, InnerPiecesStopAtTheCentreOfASmallEllipsoid) {
    Style style = plain(50);
    style.parts[0].scalp.ellipsoid.semiAxes = {0.006, 0.006, 0.006};
    const SettledGroom groom = settled(style);
    for (const Vec3f end : groom.innerEnds)
        EXPECT_LT(length(end), 1e-6F);
}

TEST(Settle, InnerPiecesAreDrawnAndNotExported) {
    const SettledGroom groom = settled(plain(50));
    const Strands drawn = withInnerPieces(groom);
    ASSERT_EQ(drawn.size(), groom.strands.size());
    for (std::size_t i = 0; i < drawn.size(); ++i) {
        ASSERT_EQ(drawn.strand(i).size(), groom.strands.strand(i).size() + 1);
        EXPECT_NEAR(length(drawn.strand(i)[0] - drawn.strand(i)[1]), 0.02, 1e-6);
        EXPECT_LT(length(drawn.strand(i)[0]), length(drawn.strand(i)[1]));
    }
}

}  // namespace
}  // namespace kushi
