// SPDX-License-Identifier: Apache-2.0
#include "pipeline/head_of_hair.h"
#include "pipeline/layers.h"

#include <kushi/settle.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <map>
#include <numbers>
#include <tuple>

#include <gtest/gtest.h>

namespace kushi {
namespace {

// Volume of hair [m3] in cubes of which more than `packing` is hair, by what is too much, counted
// anew: short pieces into the cube that holds them.
double tooMuch(const Strands& strands, double size, double section, double packing) {
    std::map<std::tuple<int, int, int>, double> cubes;
    for (std::size_t i = 0; i < strands.size(); ++i) {
        const auto nodes = strands.strand(i);
        for (std::size_t j = 1; j < nodes.size(); ++j) {
            const Vec3d from = nodes[j - 1].as<double>();
            const Vec3d way = nodes[j].as<double>() - from;
            for (int k = 0; k < 8; ++k) {
                const Vec3d at = (from + (k + 0.5) / 8 * way) / size;
                cubes[{static_cast<int>(std::floor(at.x)), static_cast<int>(std::floor(at.y)),
                       static_cast<int>(std::floor(at.z))}] += length(way) / 8 * section;
            }
        }
    }
    double excess = 0;
    for (const auto& [cube, volume] : cubes)
        excess += std::max(0.0, volume - packing * size * size * size);
    return excess;
}

// Thick hair, so that few of it are as many.
Style crowded() {
    Style style = headOfHair(3000, 20, 0.2);
    style.parts[0].hair.diameter = 300e-6;
    style.parts[0].hair.flexuralRigidity = 8e-9;
    style.parts[0].hair.density = 82.5;
    return style;
}

double sectionOf(const Style& style) {
    const double diameter = style.parts[0].hair.diameter;
    return std::numbers::pi / 4 * diameter * diameter;
}

// Settled, and its packing measured.
Result<SettledGroom> measured(const Style& style, std::optional<std::size_t> count = {}) {
    SettleOptions options;
    options.measurePenetration = true;
    options.count = count;
    return settle(style, options);
}

TEST(Crowd, IsLoosenedToThePackingAskedFor) {
    Style style = crowded();
    const auto free = measured(style);
    ASSERT_TRUE(free);
    const double before = free->report.crowding->packing;
    style.contact.packing = 0.8 * before;
    const auto loose = measured(style);
    ASSERT_TRUE(loose);
    EXPECT_LE(loose->report.crowding->packing, 1.2 * *style.contact.packing);
    EXPECT_LT(loose->report.crowding->packing, before);
    EXPECT_LE(loose->report.unsettled, 3U);
    // By another count, in cubes that are not smoothed, it has become looser too.
    const double asked = *style.contact.packing;
    EXPECT_LT(tooMuch(loose->strands, 0.005, sectionOf(style), asked),
              0.95 * tooMuch(free->strands, 0.005, sectionOf(style), asked));
}

// A fifth of 50,000 hairs of 75 micrometres, as heavy and as stiff as those and with sections of
// the same sum, whose lengths are swept into two sheets.
Style swept() {
    Style style = headOfHair(10000, 20, 0.25);
    Hair& hair = style.parts[0].hair;
    hair.diameter = 168e-6;
    hair.flexuralRigidity = 6.1e-9;
    hair.density = 263;
    constexpr double all = std::numeric_limits<double>::infinity();
    const auto sweep = [&](Range phi, Box within, Vec3d direction, double magnitude) {
        Force force;
        force.roots = {{{}, {radians(phi.low), radians(phi.high)}}};
        force.within = within;
        force.direction.vector = normalized(direction);
        force.magnitude = magnitude;
        force.falloff.distance = 0.04;
        style.parts[0].forces.push_back(force);
    };
    // From a parting to both sides, off the face, and in below.
    sweep({0, 180}, {{-0.06, all}, {0.02, all}, {}}, {-0.3, 0, 1}, 1);
    sweep({-180, 0}, {{-0.06, all}, {0.02, all}, {}}, {-0.3, 0, -1}, 1);
    sweep({-100, 100}, {{0.02, all}, {-all, 0.02}, {}}, {-1, 0, 0}, 0.5);
    sweep({-180, 180}, {{}, {-all, -0.07}, {0.09, all}}, {0, 0, -1}, 0.6);
    sweep({-180, 180}, {{}, {-all, -0.07}, {-all, -0.09}}, {0, 0, 1}, 0.6);
    return style;
}

TEST(Crowd, OfSweptHairIsLoosenedToHalfAndToAThird) {
    Style style = swept();
    const auto free = measured(style);
    ASSERT_TRUE(free);
    for (const double share : {0.5, 0.33}) {
        const double asked = share * free->report.crowding->packing;
        style.contact.packing = asked;
        const auto loose = measured(style);
        ASSERT_TRUE(loose);
        EXPECT_LE(loose->report.crowding->packing, 1.2 * asked);
        EXPECT_LE(loose->report.unsettled, 3U);
        EXPECT_LT(tooMuch(loose->strands, 0.005, sectionOf(style), asked),
                  0.2 * tooMuch(free->strands, 0.005, sectionOf(style), asked));
        // It is no bush: what is loose takes little more room.
        EXPECT_LT(loose->report.crowding->volume, 1.25 * free->report.crowding->volume);
    }
}

// A preview takes the space of all that it stands for.
TEST(Crowd, OfAPreviewIsLoosenedAsAllOfIt) {
    Style style = swept();
    constexpr std::size_t count = 2500;  // of 10,000
    const auto free = measured(style, count);
    ASSERT_TRUE(free);
    const double asked = 0.45 * 4 * free->report.crowding->packing;
    style.contact.packing = asked;
    const auto loose = measured(style, count);
    ASSERT_TRUE(loose);
    EXPECT_LE(4 * loose->report.crowding->packing, 1.25 * asked);
}

TEST(Crowd, EndsAlikeWithAnyNumberOfThreads) {
    Style style = crowded();
    style.contact.packing = 0.02;
    SettleOptions one;
    one.threads = 1;
    SettleOptions three;
    three.threads = 3;
    const auto a = settle(style, one);
    const auto b = settle(style, three);
    ASSERT_TRUE(a && b);
    EXPECT_EQ(a->strands.nodes, b->strands.nodes);
}

// Hair of the crown lies on all that grows below it; at the hem there is nothing to lie on.
TEST(Layers, RiseByHairsToTheAreaOverPacking) {
    Scalp scalp;
    scalp.ellipsoid = {{}, {0.1, 0.1, 0.1}, 0};
    scalp.count = 20000;
    scalp.regions = {{{0, radians(90)}, {}}};
    const auto follicles = plant(scalp, 3);
    ASSERT_TRUE(follicles);
    const LayerMap map = layerMapOf(scalp.ellipsoid, *follicles, 80e-6, 0.2);
    // A half sphere of 10 cm: so many to the area, wherever.
    const double each = 20000 / (2 * std::numbers::pi * 0.01);
    const double slope = each * std::numbers::pi / 4 * 80e-6 * 80e-6 / 0.2;
    for (const double theta : {20.0, 50.0, 70.0}) {
        const Layer layer = map.at({radians(theta), 0.3});
        EXPECT_NEAR(double{layer.slope}, slope, 0.15 * slope) << theta;
        EXPECT_NEAR(double{layer.reach}, radians(90 - theta) * 0.1, 0.004) << theta;
    }
    EXPECT_EQ(map.at({radians(100), 0.3}).reach, 0);
    EXPECT_LT(map.at({radians(89), 0.3}).reach, 0.004F);
}

TEST(Layers, MakeTheHairThickerTheMoreThereIs) {
    const auto width = [](int count) {
        Style style = headOfHair(count, 20, 0.15);
        style.parts[0].hair.diameter = 300e-6;
        style.parts[0].hair.flexuralRigidity = 1e-9;
        style.parts[0].hair.density = 82.5;
        const auto groom = settle(style);
        EXPECT_TRUE(groom);
        // How far nodes are off the ellipsoid, in the mean.
        double sum = 0;
        for (const Vec3f node : groom->strands.nodes) {
            const Vec3d at = node.as<double>();
            const Vec3d side = {at.x, 0, at.z};
            sum += length(side);
        }
        return sum / static_cast<double>(groom->strands.nodes.size());
    };
    EXPECT_GT(width(4000), width(1000) + 5e-4);
}

}  // namespace
}  // namespace kushi
