// SPDX-License-Identifier: Apache-2.0
#include <kushi/shade.h>

#include <cstring>
#include <limits>
#include <random>

#include <gmock/gmock.h>

namespace kushi {
namespace {

// The strands of these tests run along y, so elevations are angles above the xz plane.
Vec3f direction(double elevationDegrees, double azimuthDegrees) {
    const double e = radians(elevationDegrees);
    const double a = radians(azimuthDegrees);
    return Vec3d{std::cos(e) * std::cos(a), std::sin(e), std::cos(e) * std::sin(a)}.as<float>();
}

Strands strandOf(const std::vector<Vec3f>& nodes) {
    Strands strands;
    strands.add(nodes, 1);
    return strands;
}

Strands upright() {
    return strandOf({{0, -0.5F, 0}, {0, 0, 0}, {0, 0.5F, 0}});
}

std::vector<Rgb> shaded(const Strands& strands, Vec3f toLight, Vec3f toEye, const HairLook& look) {
    const Lights lights = {.ambient = {0.5F, 0.25F, 1}, .distant = {{toLight, {1, 0.5F, 2}}}};
    std::vector<Rgb> colors(strands.nodes.size());
    shade(strands, lights, look, 1e6F * toEye, colors);
    return colors;
}

/// A look that shows one term alone, in white.
HairLook only(float HairLook::*term, float shininess = 80) {
    HairLook look = {
        .color = {1, 1, 1}, .ambient = 0, .diffuse = 0, .specular = 0, .shininess = shininess};
    look.*term = 1;
    return look;
}

/// S at the middle of an upright strand.
float highlight(double lightElevation, double eyeElevation, double azimuth, float shininess) {
    return shaded(upright(), direction(lightElevation, 0), direction(eyeElevation, azimuth),
                  only(&HairLook::specular, shininess))[1]
        .r;
}

TEST(Shade, AddsAmbientDiffuseAndSpecular) {
    // Light and eye square to the hair, so D = S = 1.
    const HairLook look = {.color = {0.4F, 0.2F, 0.1F},
                           .specularColor = {1, 0.5F, 0.25F},
                           .ambient = 0.1F,
                           .diffuse = 0.6F,
                           .specular = 0.3F,
                           .shininess = 50};
    for (const Rgb color : shaded(upright(), {1, 0, 0}, {1, 0, 0}, look)) {
        EXPECT_NEAR(color.r, 0.1 * 0.5 * 0.4 + 1 * (0.6 * 0.4 + 0.3 * 1), 1e-6);
        EXPECT_NEAR(color.g, 0.1 * 0.25 * 0.2 + 0.5 * (0.6 * 0.2 + 0.3 * 0.5), 1e-6);
        EXPECT_NEAR(color.b, 0.1 * 1 * 0.1 + 2 * (0.6 * 0.1 + 0.3 * 0.25), 1e-6);
    }
}

TEST(Shade, DiffusesWithTheSineToTheLight) {
    for (const double elevation : {-90.0, -60.0, 0.0, 30.0, 85.0}) {
        const auto colors = shaded(upright(), direction(elevation, 40), direction(10, 120),
                                   only(&HairLook::diffuse));
        EXPECT_NEAR(colors[1].r, std::cos(radians(elevation)), 3e-4) << elevation;
    }
}

TEST(Shade, HasTheHighlightOfTheBrightestNormal) {
    // The normal that comes nearest to H, found by trying all round the hair.
    std::mt19937 random(7);
    std::uniform_real_distribution<double> elevation(-80, 80);
    std::uniform_real_distribution<double> azimuth(-170, 170);
    for (int i = 0; i < 200; ++i) {
        const double light = elevation(random);
        const double eye = elevation(random);
        const double turn = azimuth(random);
        const Vec3d sum = direction(light, 0).as<double>() + direction(eye, turn).as<double>();
        double best = 0;
        for (int step = 0; step < 36000; ++step) {
            const double angle = radians(0.01 * step);
            const Vec3d normal = {std::cos(angle), 0, std::sin(angle)};
            best = std::max(best, dot(normal, normalized(sum)));
        }
        EXPECT_NEAR(highlight(light, eye, turn, 12), std::pow(best, 12), 1e-4)
            << light << ' ' << eye << ' ' << turn;
    }
}

TEST(Shade, HasAHighlightThatNarrowsTowardsBackLight) {
    // With exponent 1 the highlight is sqrt(1 - (t.H)^2) itself. Light at 20 degrees, eye 30
    // degrees off the mirror direction; the values are rounded to three places.
    EXPECT_NEAR(highlight(20, 10, 0, 1), 0.966, 6e-4);
    EXPECT_NEAR(highlight(20, 10, 90, 1), 0.935, 6e-4);
    EXPECT_NEAR(highlight(20, 10, 150, 1), 0.696, 6e-4);
    EXPECT_NEAR(highlight(20, 10, 175, 1), 0.182, 6e-4);
}

TEST(Shade, HasTheHalfWidthsOfBlinnOnACylinder) {
    const auto halfWidth = [](float shininess) {
        double low = 0;
        double high = 90;
        for (int i = 0; i < 40; ++i) {
            const double middle = 0.5 * (low + high);
            (highlight(0, middle, 0, shininess) > 0.5F ? low : high) = middle;
        }
        return low;
    };
    EXPECT_NEAR(halfWidth(20), 30.0, 0.06);
    EXPECT_NEAR(halfWidth(80), 15.06, 0.01);
}

TEST(Shade, IsAsWideAsKajiyaAndKayWithAQuarterOfTheExponent) {
    for (int delta = 0; delta <= 15; ++delta) {
        const double kajiyaKay = std::pow(std::cos(radians(delta)), 20);
        EXPECT_NEAR(highlight(5, delta - 5, 0, 80), kajiyaKay, 4e-3) << delta;
    }
}

TEST(Shade, DoesNotCareWhichEndIsTheRoot) {
    const Strands strands = strandOf({{0, 0, 0}, {1, 2, 0}, {1, 2, 0}, {2, 2, 1}, {2, 3, 1}});
    Strands reversed = strands;
    std::reverse(reversed.nodes.begin(), reversed.nodes.end());
    const auto forth = shaded(strands, direction(30, 20), direction(0, 80), HairLook{});
    auto back = shaded(reversed, direction(30, 20), direction(0, 80), HairLook{});
    std::reverse(back.begin(), back.end());
    for (std::size_t i = 0; i < forth.size(); ++i)
        EXPECT_NEAR(forth[i].r, back[i].r, 1e-6) << i;
}

TEST(Shade, HasNoHighlightFromStraightBehind) {
    for (const float off : {0.0F, 5e-5F}) {
        const auto colors = shaded(upright(), {1, 0, 0}, {-1, 0, off}, only(&HairLook::specular));
        EXPECT_EQ(colors[1], Rgb{}) << off;
    }
    // Just beside it, H is defined and square to the hair.
    EXPECT_NEAR(highlight(0, 0, 179, 80), 1, 1e-3);
}

TEST(Shade, TakesTheStrandsOwnColors) {
    Strands strands = upright();
    strands.colors = {{1, 0, 0}, {0, 1, 0}, {0, 0, 1}};
    const auto colors = shaded(strands, {1, 0, 0}, {1, 0, 0}, only(&HairLook::diffuse));
    EXPECT_EQ(colors[0], (Rgb{1, 0, 0}));
    EXPECT_EQ(colors[1], (Rgb{0, 0.5F, 0}));
    EXPECT_EQ(colors[2], (Rgb{0, 0, 2}));
}

// Short hairs all round a ball, lit from +x: all light in front, none behind, inside or out.
TEST(Shade, LeavesHairTurnedAwayFromTheLightDark) {
    HairLook look = only(&HairLook::diffuse);
    look.body = Ellipsoid{.center = {}, .semiAxes = {1, 1, 1}};
    const auto lit = [&](float x, float z) {
        return shaded(strandOf({{x, -0.1F, z}, {x, 0.1F, z}}), {1, 0, 0}, {0, 0, 1}, look)[0].r;
    };
    EXPECT_NEAR(lit(1, 0), 1, 1e-6);
    EXPECT_GT(lit(0, 1), 0.3F);
    EXPECT_LT(lit(0, 1), 0.9F);
    EXPECT_EQ(lit(-1, 0), 0);
    EXPECT_EQ(lit(-2, 0), 0);
    look.body.reset();
    EXPECT_NEAR(lit(-1, 0), 1, 1e-6);
}

TEST(Shade, TakesStrandsWithoutLength) {
    Strands strands = strandOf({{1, 2, 3}});
    strands.add(std::vector<Vec3f>{{1, 2, 3}, {1, 2, 3}}, 2);
    for (const Rgb color : shaded(strands, direction(60, 0), direction(60, 0), HairLook{})) {
        EXPECT_TRUE(std::isfinite(color.r) && std::isfinite(color.g) && std::isfinite(color.b));
        EXPECT_GT(color.r, 0);
    }
    EXPECT_TRUE(shaded(Strands{}, {1, 0, 0}, {1, 0, 0}, HairLook{}).empty());
}

TEST(Shade, KeepsOneBadNodeFromItsNeighbours) {
    const float infinity = std::numeric_limits<float>::infinity();
    const Strands strands =
        strandOf({{0, -1, 0}, {0, -0.5F, 0}, {infinity, 0, 0}, {0, 0.5F, 0}, {0, 1, 0}});
    const auto colors = shaded(strands, {1, 0, 0}, {1, 0, 0}, only(&HairLook::diffuse));
    for (const std::size_t i : {0U, 1U, 3U, 4U})
        EXPECT_NEAR(colors[i].r, 1, 1e-6) << i;
}

TEST(Shade, GivesTheSameBytesFromAnyNumberOfThreads) {
    std::mt19937 random(3);
    std::uniform_real_distribution<float> place(-1, 1);
    Strands strands;
    for (int i = 0; i < 3000; ++i) {
        std::vector<Vec3f> nodes(static_cast<std::size_t>(1 + i % 7));
        for (Vec3f& node : nodes)
            node = {place(random), place(random), place(random)};
        strands.add(nodes, static_cast<std::uint64_t>(i));
    }
    std::vector<Rgb> one(strands.nodes.size());
    shade(strands, studioLights(), HairLook{}, {3, 1, 0}, one, 1);
    for (const int threads : {2, 8}) {
        std::vector<Rgb> many(strands.nodes.size());
        shade(strands, studioLights(), HairLook{}, {3, 1, 0}, many, threads);
        EXPECT_EQ(std::memcmp(one.data(), many.data(), one.size() * sizeof(Rgb)), 0) << threads;
    }
}

}  // namespace
}  // namespace kushi
