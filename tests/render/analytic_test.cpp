// SPDX-License-Identifier: Apache-2.0
#include "render/test_scene.h"

#include <kushi/draw.h>

#include <algorithm>
#include <cmath>
#include <numbers>
#include <random>

#include <gmock/gmock.h>

namespace kushi {
namespace {

using namespace test;

DrawOptions analytic(int size) {
    return {.width = size, .height = size, .background = black, .stroke = Stroke::Analytic};
}

/// A strand that curls once around, with the width at both ends [pixels].
Hairs curl(double radius, double first, double last, double x = 0, double y = 0) {
    Hairs hairs;
    std::vector<Vec3f> nodes;
    constexpr int segments = 30;
    for (int i = 0; i <= segments; ++i) {
        const double angle = 5.5 * i / segments;
        nodes.push_back(
            Vec3d{x + radius * std::cos(angle), y + radius * std::sin(angle), 0}.as<float>());
        hairs.strands.diameters.push_back(
            static_cast<float>(first + (last - first) * i / segments));
    }
    hairs.add(nodes, red);
    return hairs;
}

/// What a strand covers of each pixel, by 16 x 16 points: those less than half of its width off
/// some segment, but not beyond its ends.
std::vector<double> supersampled(const Hairs& hairs, int size) {
    constexpr int fine = 16;
    std::vector<double> covered(static_cast<std::size_t>(size * size));
    const auto& nodes = hairs.strands.nodes;
    for (int y = 0; y < size * fine; ++y) {
        for (int x = 0; x < size * fine; ++x) {
            const double px = (x + 0.5) / fine - 0.5 * size;
            const double py = 0.5 * size - (y + 0.5) / fine;
            for (std::size_t i = 0; i + 1 < nodes.size(); ++i) {
                const Vec3d a = nodes[i].as<double>();
                const Vec3d ab = nodes[i + 1].as<double>() - a;
                const Vec3d ap = Vec3d{px, py, 0} - a;
                double t = dot(ap, ab) / dot(ab, ab);
                if ((i == 0 && t < 0) || (i + 2 == nodes.size() && t > 1)) continue;
                t = std::clamp(t, 0.0, 1.0);
                const double width =
                    hairs.strands.diameters[i] +
                    t * (hairs.strands.diameters[i + 1] - hairs.strands.diameters[i]);
                if (length(ap - t * ab) > 0.5 * width) continue;
                covered[static_cast<std::size_t>(y / fine * size + x / fine)] +=
                    1.0 / (fine * fine);
                break;
            }
        }
    }
    return covered;
}

TEST(Analytic, CoversEachPixelAsFarAsTheStrandDoes) {
    constexpr int size = 64;
    for (const auto& [first, last] : {std::pair{0.24, 0.24}, {0.8, 0.0}, {3.0, 3.0}, {6.0, 1.0}}) {
        const Hairs hairs = curl(20, first, last, 0.3, 0.2);
        const Image image = drawn(hairs, {}, analytic(size));
        const std::vector<double> truth = supersampled(hairs, size);
        double sum = 0;
        double squares = 0;
        for (std::size_t i = 0; i < truth.size(); ++i) {
            sum += truth[i];
            squares += std::pow(image.pixels[i].r - truth[i], 2);
            EXPECT_NEAR(image.pixels[i].r, truth[i], 0.13) << first << ' ' << i;
        }
        EXPECT_NEAR(redOf(image) / sum, 1, 0.01) << first << ' ' << last;
        EXPECT_LT(std::sqrt(squares / static_cast<double>(truth.size())), 0.007) << first;
    }
}

TEST(Analytic, CoversItsWidthAndLengthWhateverTheyAre) {
    for (const double half : {0.003, 0.05, 0.3, 2.0}) {
        const double length = 20 * 30 * 2 * std::sin(0.5 * 5.5 / 30);
        for (const double shift : {0.0, 0.37, 0.81}) {
            const Image image =
                drawn(curl(20, 2 * half, 2 * half, shift, 0.5 * shift), {}, analytic(64));
            EXPECT_NEAR(redOf(image) / (length * 2 * half), 1, 0.003) << half << ' ' << shift;
        }
    }
}

TEST(Analytic, AddsUpWhatPiecesOfAStrandCover) {
    // Sixty nodes in a row of pixels: blended each on its own they would cover less.
    Hairs hairs;
    std::vector<Vec3f> nodes;
    for (int i = 0; i <= 60; ++i)
        nodes.push_back({-15.2F + 0.5F * static_cast<float>(i), 0.5F, 0});
    hairs.add(nodes, red);
    hairs.strands.diameters.assign(nodes.size(), 0.6F);
    EXPECT_NEAR(redOf(drawn(hairs, {}, analytic(64))), 30 * 0.6, 1e-3);
}

TEST(Analytic, LetsWhatIsNearerHideItsShareOfWhatIsBehind) {
    for (const float z : {0.01F, -0.01F}) {
        Hairs hairs;
        hairs.add({{-10, 0.5F, 0}, {10, 0.5F, 0}}, red);
        hairs.add({{-10, 0.5F, z}, {10, 0.5F, z}}, green);
        hairs.strands.diameters.assign(4, 0.4F);
        const Rgb pixel = drawn(hairs, {}, analytic(32)).at(16, 15);
        EXPECT_NEAR(z > 0 ? pixel.g : pixel.r, 0.4, 1e-3);
        EXPECT_NEAR(z > 0 ? pixel.r : pixel.g, 0.6 * 0.4, 1e-3);
    }
}

TEST(Analytic, HidesStrandsBehindTheMesh) {
    Mesh head;
    addRectangle(head, {-20, -20, 0}, {0.25F, 20, 0}, blue);
    Hairs hairs;
    hairs.add({{-10, 4.5F, 0.01F}, {10, 4.5F, 0.01F}}, red);
    hairs.add({{-10, -5.5F, -0.01F}, {10, -5.5F, -0.01F}}, red);
    hairs.strands.diameters.assign(4, 0.5F);
    const Image image = drawn(hairs, head, analytic(32));
    EXPECT_NEAR(image.at(10, 11).r, 0.5, 1e-3);
    EXPECT_NEAR(image.at(10, 11).b, 0.5, 1e-3);
    EXPECT_EQ(image.at(10, 21), blue);
    EXPECT_NEAR(image.at(20, 21).r, 0.5, 1e-3);
    // The mesh's edge lies a quarter of a pixel into this one.
    EXPECT_NEAR(image.at(16, 21).r, 0.75 * 0.5, 1e-3);
}

TEST(Analytic, InterpolatesColorAlongASegment) {
    Hairs hairs;
    hairs.add({{-30, 0.5F, 0}, {30, 0.5F, 0}}, {red, blue});
    hairs.strands.diameters.assign(2, 2);
    const Image image = drawn(hairs, {}, analytic(80));
    for (int x = 11; x < 69; ++x) {
        const auto t = static_cast<float>((x + 0.5 - 10) / 60);
        EXPECT_NEAR(image.at(x, 39).r, 1 - t, 1e-4);
        EXPECT_NEAR(image.at(x, 39).b, t, 1e-4);
    }
}

/// A mane of fine strands before a wall.
Hairs mane(int count) {
    std::mt19937 random(5);
    std::uniform_real_distribution<float> place(-90, 90);
    std::uniform_real_distribution<float> bend(-10, 10);
    std::uniform_real_distribution<float> shade(0.1F, 1);
    Hairs hairs;
    for (int i = 0; i < count; ++i) {
        const float x = place(random);
        const float y = place(random);
        const float z = 0.02F * place(random);
        hairs.add({{x, y + 30, z}, {x + bend(random), y, z}, {x + bend(random), y - 30, z}},
                  Rgb{1, 0, 0} * shade(random));
    }
    hairs.strands.diameters.assign(hairs.strands.nodes.size(), 0.24F);
    return hairs;
}

TEST(Analytic, IsAsBrightAsSampled) {
    Mesh wall;
    addRectangle(wall, {-100, -100, 0}, {20, 100, 0}, {0.4F, 0, 0});
    const Hairs hairs = mane(5000);
    DrawOptions options = analytic(128);
    const double soft = redOf(drawn(hairs, wall, options));
    options.stroke = Stroke::Sampled;
    EXPECT_NEAR(soft / redOf(drawn(hairs, wall, options)), 1, 0.01);
}

TEST(Analytic, DoesNotDependOnThreads) {
    Mesh wall;
    addRectangle(wall, {-100, -100, 0}, {20, 100, 0}, {0.4F, 0, 0});
    Hairs hairs = mane(3000);
    DrawOptions options = analytic(200);
    options.threads = 1;
    const Image one = drawn(hairs, wall, options);
    for (const int threads : {2, 5}) {
        options.threads = threads;
        EXPECT_EQ(drawn(hairs, wall, options).pixels, one.pixels) << threads;
    }
}

TEST(Analytic, ShowsNoTiles) {
    // The same row of strands in every column of pixels, across the edges of tiles.
    Hairs hairs;
    for (int i = 0; i < 200; ++i) {
        const float x = static_cast<float>(i) - 99.45F;
        hairs.add({{x, -90, 0}, {x, 0, 0}, {x, 90, 0}}, red);
    }
    hairs.strands.diameters.assign(hairs.strands.nodes.size(), 0.35F);
    const Image image = drawn(hairs, {}, analytic(200));
    for (int y = 11; y < 189; ++y) {
        for (int x = 1; x < 199; ++x)
            ASSERT_NEAR(image.at(x, y).r, 0.35F, 1e-3) << x << ' ' << y;
    }
}

}  // namespace
}  // namespace kushi
