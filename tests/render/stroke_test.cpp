// SPDX-License-Identifier: Apache-2.0
#include "render/test_scene.h"

#include <kushi/draw.h>

#include <cmath>
#include <numbers>
#include <random>

#include <gmock/gmock.h>

namespace kushi {
namespace {

using namespace test;

DrawOptions sampled(int size, int supersample = 4) {
    return {.width = size,
            .height = size,
            .supersample = supersample,
            .background = black,
            .stroke = Stroke::Sampled};
}

/// Straight strands that do not touch, in cells of 64 x 64 m, at random places and angles.
///
/// width, length  m
Hairs scattered(int cells, double width, double length, int seed) {
    std::mt19937 random(static_cast<std::mt19937::result_type>(seed));
    std::uniform_real_distribution<double> place(-4, 4);
    std::uniform_real_distribution<double> turn(0, 2 * std::numbers::pi);
    Hairs hairs;
    for (int i = 0; i < cells * cells; ++i) {
        const double x = 64 * (i % cells + 0.5 - 0.5 * cells) + place(random);
        const double y = 64 * (i / cells + 0.5 - 0.5 * cells) + place(random);
        const double angle = turn(random);
        std::vector<Vec3f> nodes;
        for (const double t : {-0.5, -0.2, 0.1, 0.5}) {
            nodes.push_back(
                Vec3d{x + t * length * std::cos(angle), y + t * length * std::sin(angle), 0}
                    .as<float>());
        }
        hairs.add(nodes, red);
    }
    hairs.strands.diameters.assign(hairs.strands.nodes.size(), static_cast<float>(width));
    return hairs;
}

// Half-widths of 0.003 to 2 pixels.
TEST(Sampled, CoversLengthTimesWidthToAPercent) {
    for (const double width : {0.006, 0.02, 0.1, 0.24, 0.3, 0.47, 0.53, 0.9, 1.7, 4.0}) {
        const double length = 48;
        double area = 0;
        constexpr int pictures = 12;
        constexpr int cells = 10;
        for (int i = 0; i < pictures; ++i)
            area += redOf(drawn(scattered(cells, width, length, i), {}, sampled(64 * cells)));
        EXPECT_NEAR(area / (pictures * cells * cells * length * width), 1, 0.01) << width;
    }
}

TEST(Sampled, CoversTheSameAreaAtAnyZoom) {
    constexpr int cells = 20;
    for (const double zoom : {0.03, 0.1, 0.3, 0.7, 1.5, 3.0}) {
        const int size = static_cast<int>(std::lround(64 * cells * zoom));
        const int pictures = zoom < 0.2 ? 100 : 1;  // few samples each
        double area = 0;
        for (int i = 0; i < pictures; ++i) {
            const Hairs hairs = scattered(cells, 0.8, 48, i);
            area += redOf(draw(hairs.strands, hairs.colors, {}, pixelCamera(64 * cells),
                               sampled(size, zoom < 1 ? 4 : 1)));
        }
        const double scale = size / (64.0 * cells);
        const double truth = pictures * cells * cells * 48 * 0.8 * scale * scale;
        EXPECT_NEAR(area / truth, 1, 0.015) << zoom;
    }
}

TEST(Sampled, IsAsWideAsTheDistanceMakesIt) {
    // Two of the same strand, one four times as far.
    Hairs hairs;
    hairs.add({{-20, 10, 0}, {20, 10, 0}}, red);
    hairs.add({{-80, -40, -300}, {80, -40, -300}}, red);
    hairs.strands.diameters.assign(4, 4);
    const Image image = drawn(hairs, {}, sampled(80));
    const auto across = [&](int first, int last) {
        double sum = 0;
        for (int y = first; y < last; ++y)
            sum += image.at(40, y).r;
        return sum;
    };
    EXPECT_NEAR(across(0, 40), 4, 0.01);
    EXPECT_NEAR(across(40, 80), 1, 0.01);
}

TEST(Sampled, IsSeventyFiveMicrometresWideIfNothingIsSaid) {
    Hairs hairs;
    hairs.add({{-0.02F, 0.001F, 0}, {0.02F, 0.001F, 0}}, red);
    const Camera camera = {.eye = {0, 0, 1},
                           .target = {},
                           .verticalFieldOfView = static_cast<float>(2 * std::atan(0.5 * 0.0075))};
    // A pixel is 75 micrometres.
    const Image image = draw(hairs.strands, hairs.colors, {}, camera, sampled(100));
    EXPECT_NEAR(redOf(image), 100, 1);
    DrawOptions wide = sampled(100);
    wide.widen = 7;
    EXPECT_NEAR(redOf(draw(hairs.strands, hairs.colors, {}, camera, wide)), 700, 4);
    wide.stroke = Stroke::Line;
    EXPECT_NEAR(redOf(draw(hairs.strands, hairs.colors, {}, camera, wide)), 25, 1);
}

TEST(Sampled, TapersBetweenNodes) {
    for (const float width : {16.0F, 1.0F}) {
        Hairs hairs;
        for (int i = 0; i < 8; ++i) {
            const float y = -70 + 20.3F * static_cast<float>(i);
            hairs.add({{-60, y, 0}, {-20, y, 0}, {20, y, 0}, {60, y, 0}}, red);
            for (const float share : {1.0F, 1.0F, 0.5F, 0.0F})
                hairs.strands.diameters.push_back(width * share);
        }
        const Image image = drawn(hairs, {}, sampled(160));
        const auto between = [&](int left, int right) {
            double sum = 0;
            for (int x = left; x < right; ++x) {
                for (int y = 0; y < 160; ++y)
                    sum += image.at(x, y).r;
            }
            return sum / (8 * (right - left));
        };
        EXPECT_NEAR(between(20, 60), width, 0.02 * width);
        EXPECT_NEAR(between(60, 100), 0.75 * width, 0.02 * width);
        EXPECT_NEAR(between(100, 140), 0.25 * width, 0.02 * width);
        if (width > 4) {
            EXPECT_NEAR(between(125, 135), 0.125 * width, 0.01 * width);
        }
    }
}

TEST(Sampled, LeavesOutWhatHasNoWidth) {
    Hairs hairs;
    for (const float y : {-10.0F, 0.0F, 10.0F})
        hairs.add({{-30, y, 0}, {30, y, 0}}, red);
    hairs.strands.diameters = {0, 0, -5, -5, NAN, NAN};
    EXPECT_EQ(redOf(drawn(hairs, {}, sampled(80))), 0);
}

/// A strand along three quarters of a circle, which turns past both axes and all diagonals.
Hairs arc(double radius, double width, int segments) {
    Hairs hairs;
    std::vector<Vec3f> nodes;
    for (int i = 0; i <= segments; ++i) {
        const double angle = 0.1 + 1.5 * std::numbers::pi * i / segments;
        nodes.push_back(Vec3d{radius * std::cos(angle), radius * std::sin(angle), 0}.as<float>());
    }
    hairs.add(nodes, red);
    hairs.strands.diameters.assign(nodes.size(), static_cast<float>(width));
    return hairs;
}

TEST(Sampled, HasNeitherGapsNorBulgesWhereItTurns) {
    for (const double width : {3.0, 12.0, 30.0}) {
        constexpr double radius = 80;
        constexpr int segments = 18;
        const Image image = drawn(arc(radius, width, segments), {}, sampled(240));
        // Ribbons along the chords, on mitres: the area of the polygons between.
        const double step = 1.5 * std::numbers::pi / segments;
        const double chord = 2 * radius * std::sin(0.5 * step);
        EXPECT_NEAR(redOf(image), segments * chord * width, 0.005 * segments * chord * width);

        const double sagitta = radius * (1 - std::cos(0.5 * step));
        for (int y = 0; y < 240; ++y) {
            for (int x = 0; x < 240; ++x) {
                const double away = std::hypot(x - 119.5, y - 119.5) - radius;
                double angle = std::atan2(119.5 - y, x - 119.5);
                if (angle < 0) angle += 2 * std::numbers::pi;
                const bool along = angle > 0.2 && angle < 1.5 * std::numbers::pi;
                if (along && std::abs(away) < 0.5 * width - sagitta - 1) {
                    ASSERT_EQ(image.at(x, y).r, 1) << width << ": " << x << ' ' << y;
                }
                if (std::abs(away) > 0.5 * width / std::cos(0.5 * step) + sagitta + 1) {
                    ASSERT_EQ(image.at(x, y).r, 0) << width << ": " << x << ' ' << y;
                }
            }
        }
    }
}

TEST(Sampled, DoesNotShowWhereLinesBecomeRibbons) {
    // Both sides of two samples.
    const double narrow = redOf(drawn(arc(80, 0.499, 60), {}, sampled(240)));
    const double wide = redOf(drawn(arc(80, 0.501, 60), {}, sampled(240)));
    EXPECT_NEAR(wide / narrow, 0.501 / 0.499, 0.01);
}

TEST(Sampled, KeepsWhatIsCoveredIfFewerStrandsAreWidened) {
    constexpr int size = 256;
    constexpr int count = 8000;
    const auto coverage = [](int stride) {
        std::mt19937 random(5);
        std::uniform_real_distribution<double> place(-0.5 * size - 30, 0.5 * size + 30);
        std::uniform_real_distribution<double> bend(-20, 20);
        Hairs hairs;
        for (int i = 0; i < count; ++i) {
            const double x = place(random);
            const double y = place(random);
            const double end = x + bend(random);
            if (i % stride != 0) continue;
            const auto z = static_cast<float>(0.001 * place(random));
            hairs.add(
                {Vec3d{x, y + 25, z}.as<float>(), Vec3d{0.6 * x + 0.4 * end, y, z}.as<float>(),
                 Vec3d{end, y - 25, z}.as<float>()},
                red);
        }
        hairs.strands.diameters.assign(hairs.strands.nodes.size(), 0.24F);
        DrawOptions options = sampled(size);
        options.widen = static_cast<float>(stride);
        return redOf(drawn(hairs, {}, options)) / (size * size);
    };
    const double all = coverage(1);
    EXPECT_GT(all, 0.3);
    EXPECT_LT(all, 0.8);
    for (const int stride : {2, 4, 8})
        EXPECT_NEAR(coverage(stride) / all, 1, 0.05) << stride;
}

TEST(Sampled, DoesNotDependOnThreads) {
    Hairs hairs = scattered(10, 1, 60, 3);
    for (std::size_t i = 0; i < hairs.strands.nodes.size(); ++i)
        hairs.strands.diameters[i] = 0.001F * static_cast<float>(i * i % 5000);
    DrawOptions options = sampled(640);
    options.threads = 1;
    const Image one = drawn(hairs, {}, options);
    for (const int threads : {2, 5}) {
        options.threads = threads;
        EXPECT_EQ(drawn(hairs, {}, options).pixels, one.pixels) << threads;
    }
}

TEST(Sampled, RefusesToWidenByNonsense) {
    for (const float widen : {0.0F, -1.0F, NAN, 2e6F}) {
        DrawOptions options = sampled(16);
        options.widen = widen;
        EXPECT_TRUE(drawn({}, {}, options).pixels.empty()) << widen;
    }
}

}  // namespace
}  // namespace kushi
