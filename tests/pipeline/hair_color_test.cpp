// SPDX-License-Identifier: Apache-2.0
#include "pipeline/hair_color.h"

#include "core/random.h"

#include <cmath>
#include <map>
#include <set>

#include <gtest/gtest.h>

namespace kushi {
namespace {

constexpr Rgb brown = {0.2F, 0.1F, 0.05F};
constexpr Rgb blond = {0.6F, 0.4F, 0.2F};

// Without what hair varies by.
Part plain() {
    Part part;
    part.hair.color = brown;
    part.hair.variation = 0;
    return part;
}

constexpr int nodeCount = 101;

// 20 cm straight down, a node every 2 mm.
std::vector<Rgb> colorsOf(const Part& part, std::uint64_t key, EllipsoidAngles angles = {},
                          Vec3d root = {}) {
    std::vector<Vec3f> nodes;
    for (int j = 0; j < nodeCount; ++j)
        nodes.push_back((root + Vec3d{0, -0.002 * j, 0}).as<float>());
    std::vector<Rgb> colors;
    appendHairColors(part, key, angles, nodes, colors);
    EXPECT_EQ(colors.size(), nodes.size());
    return colors;
}

// How much of the second colour is in a third, by red alone and away from the dark roots.
double shareOf(Rgb color) {
    const double share = double{color.r - brown.r} / double{blond.r - brown.r};
    EXPECT_NEAR(color.g, brown.g + share * double{blond.g - brown.g}, 1e-5);
    return share;
}

std::size_t at(double centimetres) {
    return static_cast<std::size_t>(std::lround(centimetres / 0.2));
}

TEST(HairColor, OfTipsFadesInTowardsThem) {
    Part part = plain();
    part.hair.tips = {blond, 0.1, 0.06};
    const std::vector<Rgb> colors = colorsOf(part, 1);
    // 10 cm from the tip it begins, 4 cm from it it is there; later or earlier by 1.5 cm.
    EXPECT_EQ(colors[at(8.4)], brown);
    EXPECT_NEAR(shareOf(colors[at(17.6)]), 1, 1e-6);
    EXPECT_NEAR(shareOf(colors[at(20)]), 1, 1e-6);
    double last = 0;
    for (std::size_t j = at(8); j < nodeCount; ++j) {
        EXPECT_GE(shareOf(colors[j]), last - 1e-6);
        last = shareOf(colors[j]);
    }
    double sum = 0;
    for (std::uint64_t key = 0; key < 400; ++key)
        sum += shareOf(colorsOf(part, key)[at(13)]);
    EXPECT_NEAR(sum / 400, 0.5, 0.05);
}

TEST(HairColor, OfRegrowthIsAtTheRootsOverAllElse) {
    Part part = plain();
    part.hair.color = {1, 1, 1};
    part.hair.regrowth = {blond, 0.06, 0.02};
    Highlight all;
    all.share = 1;
    all.color = brown;
    part.highlights = {all};
    const std::vector<Rgb> colors = colorsOf(part, 1);
    EXPECT_NEAR(shareOf(colors[at(3.4)]), 1, 1e-6);
    EXPECT_NEAR(shareOf(colors[at(6.6)]), 0, 1e-6);
    // The roots as dark as ever.
    EXPECT_NEAR(colors[0].r, 0.65 * double{blond.r}, 1e-6);
}

TEST(HairColor, WithoutABlendEndsAtOnce) {
    Part part = plain();
    part.hair.regrowth = {blond, 0.05, 0};
    const std::vector<Rgb> colors = colorsOf(part, 1);
    EXPECT_NEAR(shareOf(colors[at(4.8)]), 1, 1e-6);
    EXPECT_NEAR(shareOf(colors[at(5.2)]), 0, 1e-6);
}

TEST(HairColor, OfGreyStrandsIsAllTheirs) {
    Part part = plain();
    part.hair.grey = {0.3, blond};
    int grey = 0;
    for (std::uint64_t key = 0; key < 4000; ++key) {
        const std::vector<Rgb> colors = colorsOf(part, scramble(key));
        const double share = shareOf(colors[at(10)]);
        EXPECT_TRUE(share < 1e-6 || share > 1 - 1e-6);
        EXPECT_EQ(colors[at(10)], colors[at(20)]);
        grey += share > 0.5 ? 1 : 0;
    }
    // Four standard deviations.
    EXPECT_NEAR(grey, 1200, 4 * std::sqrt(4000 * 0.3 * 0.7));
}

TEST(HairColor, OfHighlightsIsOnTheirShareOfTheirRootsAndStretch) {
    Part part = plain();
    Highlight streaks;
    streaks.roots = {{{0, radians(60)}, {}}};
    streaks.share = 0.25;
    streaks.color = blond;
    streaks.from = 0.05;
    streaks.to = 0.15;
    streaks.blend = 0.01;
    part.highlights = {streaks};
    int lit = 0;
    for (std::uint64_t key = 0; key < 4000; ++key) {
        const std::vector<Rgb> colors = colorsOf(part, scramble(key), {radians(30), 0});
        EXPECT_EQ(colors[at(4)], brown);
        EXPECT_EQ(colors[at(16)], brown);
        lit += shareOf(colors[at(10)]) > 0.999 ? 1 : 0;
        EXPECT_EQ(colorsOf(part, scramble(key), {radians(61), 0})[at(10)], brown);
    }
    EXPECT_NEAR(lit, 1000, 4 * std::sqrt(4000 * 0.25 * 0.75));
}

TEST(HairColor, OfTwoHighlightsIsThatOfTheLater) {
    Part part = plain();
    Highlight first;
    first.share = 1;
    first.color = {1, 1, 1};
    Highlight second = first;
    second.color = blond;
    part.highlights = {first, second};
    EXPECT_NEAR(shareOf(colorsOf(part, 1)[at(10)]), 1, 1e-6);
}

// Strands of a foil go together; which foils do, is in the share.
TEST(HairColor, OfFoilsIsThatOfNeighbours) {
    Part part = plain();
    Highlight foils;
    foils.share = 0.3;
    foils.color = blond;
    foils.foil = 0.01;
    part.highlights = {foils};
    int lit = 0;
    int alike = 0;
    constexpr int places = 4000;
    for (std::uint64_t i = 0; i < places; ++i) {
        const Vec3d root = {0.5 * uniform(2 * i), 0, 0.5 * uniform(2 * i + 1)};
        const bool one = colorsOf(part, scramble(i), {}, root)[at(10)] != brown;
        const bool beside =
            colorsOf(part, scramble(i + places), {}, root + Vec3d{5e-4, 0, 0})[at(10)] != brown;
        lit += one ? 1 : 0;
        alike += one == beside ? 1 : 0;
    }
    // Some 2500 foils.
    EXPECT_NEAR(lit / double{places}, 0.3, 4 * std::sqrt(0.3 * 0.7 / 2000));
    EXPECT_GT(alike, 0.94 * places);
    EXPECT_LT(alike, places);
}

// As before there were other colours.
TEST(HairColor, AloneIsTheHairsAndVaries) {
    Part part = plain();
    part.hair.variation = 0.2;
    std::set<float> reds;
    for (std::uint64_t key = 0; key < 100; ++key) {
        const std::vector<Rgb> colors = colorsOf(part, key);
        EXPECT_NEAR(colors.back().g / colors.back().r, 0.5, 1e-5);
        EXPECT_NEAR(colors.back().r / brown.r, 1, 0.2 + 1e-6);
        EXPECT_NEAR(colors[0].r / colors.back().r, 0.65, 1e-5);
        reds.insert(colors.back().r);
    }
    EXPECT_GT(reds.size(), 90U);
}

}  // namespace
}  // namespace kushi
