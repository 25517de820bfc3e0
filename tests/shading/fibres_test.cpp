// SPDX-License-Identifier: Apache-2.0
#include "every_target.h"
#include "shading/lattice.h"

#include <kushi/shadows.h>

#include <algorithm>
#include <cmath>
#include <cstring>
#include <numbers>

#include <gmock/gmock.h>

namespace kushi {
namespace {

constexpr double pi = std::numbers::pi;
constexpr Rgb white = {0.98F, 0.98F, 0.98F};
constexpr Rgb blond = {0.35F, 0.22F, 0.10F};
constexpr Rgb black = {0.006F, 0.005F, 0.005F};

Strands upright() {
    Strands strands;
    strands.add(std::vector<Vec3f>{{0, -0.05F, 0}, {0, 0, 0}, {0, 0.05F, 0}}, 1);
    return strands;
}

Lights oneLight(Vec3f towards) {
    return {.ambient = {}, .distant = {{normalized(towards), {1, 1, 1}}}};
}

/// An upright strand too thin to shade itself, as it looks in the middle.
class Alone {
public:
    Alone(Rgb color, Vec3f towardsLight)
        : look_{.color = color, .fibre = {.longitudinal = 0.2}, .tiltVariation = 0},
          lights_(oneLight(towardsLight)),
          shadows_(thin(), {}, lights_) {}

    Rgb from(Vec3f towardsEye) const {
        std::vector<Rgb> colors(3);
        shade(upright(), lights_, shadows_, look_, 100.0F * towardsEye, colors, 1);
        return colors[1];
    }

private:
    static Strands thin() {
        Strands strand = upright();
        strand.diameters.assign(3, 1e-9F);
        return strand;
    }

    FibreLook look_;
    Lights lights_;
    Shadows shadows_;
};

/// What a fibre in a light sends to all sides, to what it receives.
double sent(Rgb color, Vec3f towardsLight) {
    const Alone fibre(color, towardsLight);
    double sum = 0;
    constexpr int rows = 24;
    constexpr int columns = 24;
    for (int i = 0; i < rows; ++i) {
        const double height = -1 + (i + 0.5) * 2 / rows;
        for (int j = 0; j < columns; ++j) {
            const double angle = 2 * pi * (j + 0.5) / columns;
            const double around = std::sqrt(1 - height * height);
            const Vec3d eye = {around * std::cos(angle), height, around * std::sin(angle)};
            sum += static_cast<double>(fibre.from(eye.as<float>()).g) * 4 * pi / (rows * columns);
        }
    }
    // The light gives pi to a surface square to it.
    return sum / pi;
}

TEST(ShadeFibres, AClearFibreSendsOnWhatItGets) {
    EXPECT_NEAR(sent(white, {1, 0, 0}), 1, 0.05);
    EXPECT_NEAR(sent(white, {1, 0.6F, 0}), 1, 0.08);
    EXPECT_LT(sent(blond, {1, 0, 0}), 0.95);
    EXPECT_LT(sent(black, {1, 0, 0}), 0.45);
}

TEST(ShadeFibres, BlondShinesAgainstTheLightAndBlackGivesItBack) {
    const auto luminance = [](Rgb c) { return 0.2126F * c.r + 0.7152F * c.g + 0.0722F * c.b; };
    EXPECT_GT(luminance(Alone(blond, {1, 0, 0}).from({-1, 0, 0})),
              8 * luminance(Alone(blond, {1, 0, 0}).from({1, 0, 0})));
    // Black hair shows the light's own colour in its highlight.
    const Rgb sheen = Alone(black, {1, 0, 0}).from({1, 0, 0});
    EXPECT_GT(sheen.g, 0.02F);
    EXPECT_NEAR(sheen.r / sheen.g, 1, 0.05);
    EXPECT_NEAR(sheen.b / sheen.g, 1, 0.05);
    // Blond hair against the light is more coloured than its pigment seen once.
    const Rgb through = Alone(blond, {1, 0, 0}).from({-1, 0, 0});
    EXPECT_GT(through.r, 1.1F * through.b);
}

/// A quarter of a circle from its top, a node each eighth of a degree, seen from the front.
class Arch {
public:
    explicit Arch(std::uint64_t key) {
        std::vector<Vec3f> nodes;
        for (int i = 0; i <= last; ++i) {
            const double angle = pi / 2 * i / last;
            nodes.push_back(Vec3d{0.1 * std::sin(angle), 0.1 * std::cos(angle), 0}.as<float>());
        }
        arch_.add(nodes, key);
        arch_.diameters.assign(nodes.size(), 1e-9F);
    }

    std::vector<Rgb> shaded(Rgb color, double tilt, float variation) const {
        const Lights lights = oneLight({0.5F, 0.866F, 0});
        const Shadows shadows(arch_, {}, lights);
        std::vector<Rgb> colors(arch_.nodes.size());
        const Fibre fibre = {.longitudinal = 0.1, .tilt = radians(tilt)};
        shade(arch_, lights, shadows, {.color = color, .fibre = fibre, .tiltVariation = variation},
              {100, 0, 0}, colors, 1);
        return colors;
    }

    /// Degrees from the top.
    static double brightest(const std::vector<Rgb>& colors) {
        const auto most = std::ranges::max_element(colors, {}, &Rgb::r);
        return 90.0 * static_cast<double>(most - colors.begin()) / last;
    }

private:
    static constexpr int last = 720;

    Strands arch_;
};

// R is deflected towards the root: seen from the side the highlight of an arch moves to the tip, by
// the tilt of the scales.
TEST(ShadeFibres, TheWhiteBandMovesTowardsTheTip) {
    const Arch arch(0);
    const auto band = [&](double tilt) { return Arch::brightest(arch.shaded(black, tilt, 0)); };
    const double straight = band(0);
    EXPECT_NEAR(straight, 60, 1);
    EXPECT_NEAR(band(2) - straight, 2, 0.5);
    EXPECT_NEAR(band(4) - straight, 4, 0.7);
}

// Each strand has a tilt of its own; where its white band moves to the tip, its coloured one moves
// to the root.
TEST(ShadeFibres, BandsDifferFromStrandToStrand) {
    constexpr float variation = 0.05F;
    double least = 0;
    double most = 0;
    for (std::uint64_t key = 0; key < 12; ++key) {
        const Arch arch(key);
        const auto coloured = [&](float varied) {
            std::vector<Rgb> light = arch.shaded(blond, 2, varied);
            const std::vector<Rgb> dark = arch.shaded(black, 2, varied);
            for (std::size_t i = 0; i < light.size(); ++i)
                light[i] += -1.0F * dark[i];
            return Arch::brightest(light);
        };
        const double moved = Arch::brightest(arch.shaded(black, 2, variation)) -
                             Arch::brightest(arch.shaded(black, 2, 0));
        EXPECT_LE(std::abs(moved), degrees(static_cast<double>(variation)) + 0.5);
        if (std::abs(moved) > 0.5) {
            EXPECT_LT(moved * (coloured(variation) - coloured(0)), 0) << key;
        }
        least = std::min(least, moved);
        most = std::max(most, moved);
    }
    EXPECT_LT(least, -1);
    EXPECT_GT(most, 1);
}

TEST(ShadeFibres, HairBehindHairIsDarkerAndWarmer) {
    const Strands hair = test::lattice(40, 0.0051F, 0.3F, 0.0012F);
    const Lights lights = oneLight({1, 0.2F, 0});
    const Shadows shadows(hair, {}, lights);
    std::vector<Rgb> colors(hair.nodes.size());
    shade(hair, lights, shadows, {.color = blond, .tiltVariation = 0}, {100, 10, 0}, colors, 2);
    // In the middle of the side that faces light and eye, and some rows behind.
    const auto at = [&](std::size_t row) { return colors[hair.offsets[row * 40 + 20] + 10]; };
    const Rgb front = at(39);
    const Rgb behind = at(30);
    EXPECT_LT(behind.g, 0.7F * front.g);
    EXPECT_GT(behind.r / behind.b, 1.1F * front.r / front.b);
    EXPECT_GT(behind.r, 0);
}

// All around equally bright, clear hair looks as bright as what is around it, and none brighter.
TEST(ShadeFibres, InAWhiteRoomWhiteHairIsWhite) {
    const Strands hair = test::lattice(40, 0.0051F, 0.3F, 0.0012F);
    const Lights lights = {.ambient = {1, 1, 1}, .distant = {}};
    const Shadows shadows(hair, {}, lights);
    std::vector<Rgb> colors(hair.nodes.size());
    shade(hair, lights, shadows, {.color = {0.99F, 0.99F, 0.99F}}, {100, 10, 0}, colors, 2);
    const Rgb front = colors[hair.offsets[39 * 40 + 20] + 10];
    EXPECT_GT(front.g, 0.6F);
    for (const Rgb color : colors)
        EXPECT_LE(color.g, 1.02F);
}

TEST(ShadeFibres, TheSameFromAnyNumberOfThreads) {
    const Strands hair = test::lattice(30, 0.005F, 0.2F, 2e-4F);
    const Lights lights = portraitLights();
    const Shadows shadows(hair, {}, lights);
    std::vector<Rgb> one(hair.nodes.size());
    shade(hair, lights, shadows, {}, {1, 0.2F, 0.3F}, one, 1);
    for (const int threads : {2, 3}) {
        std::vector<Rgb> more(hair.nodes.size());
        shade(hair, lights, shadows, {}, {1, 0.2F, 0.3F}, more, threads);
        EXPECT_EQ(std::memcmp(more.data(), one.data(), one.size() * sizeof(Rgb)), 0);
    }
}

using FibreLanesTest = OnEveryTarget;

TEST_F(FibreLanesTest, AllProcessorsGiveTheSameBytes) {
    const Strands hair = test::lattice(30, 0.004F, 0.2F, 2e-4F);
    const Lights lights = portraitLights();
    const Shadows shadows(hair, {}, lights);
    std::vector<Rgb> first;
    for (const std::int64_t target : targetsHere()) {
        use(target);
        std::vector<Rgb> colors(hair.nodes.size());
        shade(hair, lights, shadows, {.color = blond}, {1, 0.2F, 0.3F}, colors);
        if (first.empty()) first = colors;
        EXPECT_EQ(std::memcmp(colors.data(), first.data(), first.size() * sizeof(Rgb)), 0)
            << hwy::TargetName(target);
    }
}

TEST(ShadeFibres, SomeNodesHaveTheColorsThatAllHave) {
    Strands strands = test::lattice(12, 0.001F, 0.06F, 2e-4F, 9);
    for (std::size_t i = 0; i < strands.nodes.size(); ++i)
        strands.colors.push_back(i % 7 == 0 ? black : blond);
    const Lights lights = portraitLights();
    const Shadows shadows(strands, {}, lights);
    const Vec3f eye = {1, 0.2F, 0.3F};
    std::vector<Rgb> all(strands.nodes.size());
    shade(strands, lights, shadows, FibreLook(), eye, all);
    const NodeColors colorsOf = nodeColors(strands, lights, shadows, FibreLook(), eye);
    for (const std::uint32_t step : {1U, 3U, 11U, 400U}) {
        std::vector<std::uint32_t> nodes;
        for (std::uint32_t node = step / 2; node < all.size(); node += step)
            nodes.push_back(node);
        std::vector<Rgb> some(nodes.size(), Rgb{-1, -1, -1});
        colorsOf(nodes, some);
        for (std::size_t i = 0; i < nodes.size(); ++i)
            ASSERT_EQ(some[i], all[nodes[i]]) << nodes[i];
    }
}

TEST(ShadeFibres, TakesWhatComes) {
    Strands strands;
    strands.add(std::vector<Vec3f>{{0, 0, 0}}, 0);
    strands.add(std::vector<Vec3f>{{0, 0, 0}, {0, 0, 0}}, 1);
    strands.add(std::vector<Vec3f>{{0, 0, 0}, {0, 1, 0}, {0, 0, 0}}, 2);
    Lights lights = portraitLights();
    lights.distant.push_back({{0, 1, 0}, {1, 1, 1}});   // along a strand
    lights.distant.push_back({{0, -1, 0}, {1, 1, 1}});  // a second group of four
    const Shadows shadows(strands, {}, lights);
    for (const Vec3f eye : {Vec3f{0, 9, 0}, Vec3f{1, 0, 0}, Vec3f{0, 0, 0}}) {
        std::vector<Rgb> colors(strands.nodes.size());
        shade(strands, lights, shadows, {}, eye, colors);
        for (const Rgb color : colors) {
            EXPECT_TRUE(std::isfinite(color.r) && std::isfinite(color.g) && std::isfinite(color.b));
            EXPECT_GE(color.r, 0);
        }
    }
}

TEST(ShadeMatt, SkinLiesInTheShadowOfHairAndHead) {
    const Mesh ball = ellipsoidMesh({.center = {}, .semiAxes = {0.1, 0.1, 0.1}, .rotateZ = 0}, 60);
    const Lights lights = oneLight({0, 1, 0});
    const std::vector<Rgb> albedo(ball.vertices.size(), Rgb{0.5F, 0.5F, 0.5F});
    // A mat of hair 12 cm above the middle.
    Strands mat;
    for (int i = 0; i < 2000; ++i) {
        const float z = -0.05F + 5e-5F * static_cast<float>(i);
        mat.add(std::vector<Vec3f>{{-0.05F, 0.12F, z}, {0, 0.12F, z}, {0.05F, 0.12F, z}},
                static_cast<std::uint64_t>(i));
    }
    const std::vector<Rgb> bare = shadeMatt(ball, lights, albedo, Shadows({}, ball, lights));
    const std::vector<Rgb> below = shadeMatt(ball, lights, albedo, Shadows(mat, ball, lights));
    const std::vector<Rgb> open = shadeMatt(ball, lights, albedo);
    for (std::size_t i = 0; i < ball.vertices.size(); ++i) {
        const Vec3f v = ball.vertices[i];
        if (v.y > 0.05F) {
            EXPECT_NEAR(bare[i].g, open[i].g, 2e-3F) << v.x << ' ' << v.y << ' ' << v.z;
        }
        if (v.y < -0.01F) {
            EXPECT_EQ(bare[i].g, 0);
        }
        if (v.y > 0.095F) {
            EXPECT_LT(below[i].g, 0.6F * bare[i].g);
        }
    }
}

}  // namespace
}  // namespace kushi
