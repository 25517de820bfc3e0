// SPDX-License-Identifier: Apache-2.0
// What a renderer must bear: crowds, cameras inside the hair, coordinates that mean nothing.
#include "render/test_scene.h"

#include <kushi/draw.h>

#include <cstring>
#include <limits>
#include <random>

#include <gmock/gmock.h>

namespace kushi {
namespace {

using namespace test;

constexpr float nan = std::numeric_limits<float>::quiet_NaN();
constexpr float infinity = std::numeric_limits<float>::infinity();

DrawOptions small(int supersample = 1) {
    return {.width = 80, .height = 60, .supersample = supersample, .background = black};
}

TEST(DrawLimits, GiveTheSameBytesFromAnyNumberOfThreads) {
    std::mt19937 random(1);
    std::uniform_real_distribution<float> place(-120, 120);
    std::uniform_real_distribution<float> light(0, 1);
    Hairs hairs;
    for (int i = 0; i < 3000; ++i) {
        std::vector<Vec3f> nodes(static_cast<std::size_t>(i % 6));
        std::vector<Rgb> colors(nodes.size());
        for (Vec3f& node : nodes)
            node = {place(random), place(random), place(random)};
        for (Rgb& color : colors)
            color = {light(random), light(random), light(random)};
        hairs.add(nodes, colors);
    }
    Mesh mesh = ellipsoidMesh({.center = {}, .semiAxes = {70, 60, 50}}, 30);
    mesh.colors.assign(mesh.vertices.size(), blue);
    DrawOptions options = {.width = 210, .height = 190, .supersample = 2, .threads = 1};
    const Image one = drawn(hairs, mesh, options);
    for (const int threads : {2, 8, 0}) {
        options.threads = threads;
        const Image many = drawn(hairs, mesh, options);
        ASSERT_EQ(many.pixels.size(), one.pixels.size());
        EXPECT_EQ(
            std::memcmp(one.pixels.data(), many.pixels.data(), one.pixels.size() * sizeof(Rgb)), 0)
            << threads;
    }
}

TEST(DrawLimits, HoldAMillionSegmentsInOnePixel) {
    // All across the pixel (40, 29), each a little nearer than the one before.
    Hairs hairs;
    std::vector<Vec3f> nodes;
    std::vector<Rgb> colors;
    for (int i = 0; i <= 1000000; ++i) {
        nodes.push_back({i % 2 == 0 ? 0.1F : 0.9F, 0.55F, static_cast<float>(i) * 1e-6F});
        colors.push_back(i < 999000 ? red : green);
    }
    hairs.add(nodes, colors);
    const Image image = drawn(hairs, {}, small(4));
    EXPECT_EQ(image.at(40, 29), (Rgb{0, 0.25F, 0}));  // one row of samples, four long
    EXPECT_EQ(image.at(41, 29), black);
    EXPECT_EQ(image.at(39, 29), black);
}

TEST(DrawLimits, CutStrandsAtTheCamera) {
    // From the picture's middle past the camera, on its right.
    Hairs hairs;
    hairs.add({{0, 0.1F, 0}, {30, 0.1F, 200}}, {red, green});
    const Image image = drawn(hairs, {}, small());
    for (int x = 41; x < 80; ++x) {
        // x = 100 * 30 t / (100 - 200 t) in pixels from the middle.
        const double right = x + 0.5 - 40;
        const double t = right / (30 + 2 * right);
        EXPECT_NEAR(image.at(x, 29).g, t, 1e-3) << x;
        EXPECT_NEAR(image.at(x, 29).r, 1 - t, 1e-3) << x;
    }
    // The other way round it is the same hair.
    Hairs reversed;
    reversed.add({{30, 0.1F, 200}, {0, 0.1F, 0}}, {green, red});
    const Image other = drawn(reversed, {}, small());
    for (int x = 41; x < 80; ++x)
        EXPECT_NEAR(other.at(x, 29).g, image.at(x, 29).g, 1e-4) << x;
}

TEST(DrawLimits, LeaveOutWhatLiesBehindTheCamera) {
    Hairs hairs;
    hairs.add({{-1, 0, 150}, {1, 0, 150}}, red);
    Mesh mesh;
    addRectangle(mesh, {-20, -20, 150}, {20, 20, 150}, red);
    EXPECT_EQ(redOf(drawn(hairs, mesh, small(2))), 0);
}

TEST(DrawLimits, CutTrianglesAtTheCamera) {
    // A floor 10 m below the eye, from far behind to far before: it fills what is below the
    // horizon.
    Mesh mesh;
    mesh.vertices = {
        {-9000, -10, 9000}, {9000, -10, 9000}, {9000, -10, -9000}, {-9000, -10, -9000}};
    mesh.colors.assign(4, red);
    mesh.triangles = {{0, 1, 2}, {0, 2, 3}};
    const Image image = drawn({}, mesh, small());
    for (int x = 0; x < 80; ++x) {
        for (int y = 0; y < 60; ++y) {
            // The far border is 10 / 9100 * 100 = 0.11 pixels below the horizon.
            ASSERT_NEAR(image.at(x, y).r, y >= 30 ? 1 : 0, 1e-4) << x << ' ' << y;
        }
    }
}

TEST(DrawLimits, LeaveOutWhatIsNotFinite) {
    Hairs hairs;
    for (const float bad : {nan, infinity, -infinity, 3e38F, -3e38F}) {
        hairs.add({{-30, 0.5F, 0}, {-10, 0.5F, 0}, {bad, 0.5F, 0}, {10, 0.5F, 0}, {30, 0.5F, 0}},
                  red);
        hairs.add({{bad, bad, bad}, {bad, 0, bad}}, red);
        hairs.add({{0, 0, bad}, {1, bad, 0}}, red);
    }
    Mesh mesh;
    addRectangle(mesh, {-5, 10, 0}, {5, 20, 0}, blue);
    mesh.vertices.push_back({nan, infinity, 3e38F});
    mesh.colors.push_back(red);
    mesh.triangles.push_back({0, 1, 4});
    const Image image = drawn(hairs, mesh, small());
    EXPECT_EQ(redOf(image), 40);  // the two good segments, 20 pixels each
    EXPECT_EQ(image.at(40, 15), blue);
}

TEST(DrawLimits, BearAnything) {
    std::mt19937 random(2);
    std::uniform_real_distribution<float> exponent(-30, 38);
    const auto wild = [&] {
        const float size = std::pow(10.0F, exponent(random));
        return random() % 50 == 0 ? nan : (random() % 2 == 0 ? size : -size);
    };
    Hairs hairs;
    for (int i = 0; i < 20000; ++i) {
        std::vector<Vec3f> nodes(static_cast<std::size_t>(i % 4));
        for (Vec3f& node : nodes)
            node = {wild(), wild(), wild()};
        hairs.add(nodes, red);
    }
    Mesh mesh;
    for (std::uint32_t i = 0; i < 3000; ++i) {
        mesh.vertices.push_back({wild(), wild(), wild()});
        mesh.triangles.push_back({i, i / 2, i / 3});
    }
    for (const int supersample : {1, 4}) {
        EXPECT_EQ(drawn(hairs, mesh, small(supersample)).pixels.size(), 4800U);
    }
    for (int i = 0; i < 20; ++i) {
        const Camera camera = {.eye = {wild(), wild(), wild()},
                               .target = {wild(), wild(), wild()},
                               .up = {wild(), wild(), wild()},
                               .verticalFieldOfView = wild()};
        const Image image = draw(hairs.strands, hairs.colors, mesh, camera, small());
        EXPECT_EQ(image.pixels.size(), 4800U);
    }
}

TEST(DrawLimits, GiveAnEmptyImageForOptionsOutOfRange) {
    const auto pixels = [](const DrawOptions& options) {
        return drawn({}, {}, options).pixels.size();
    };
    EXPECT_EQ(pixels({.width = 0}), 0U);
    EXPECT_EQ(pixels({.height = 16385}), 0U);
    EXPECT_EQ(pixels({.supersample = 3}), 0U);
    EXPECT_EQ(pixels({.width = 8, .height = 8}), 64U);
    Hairs hairs;
    hairs.add({{0, 0, 0}, {1, 0, 0}}, red);
    hairs.colors.pop_back();
    EXPECT_TRUE(drawn(hairs, {}, small()).pixels.empty());
    Mesh mesh;
    addRectangle(mesh, {0, 0, 0}, {1, 1, 0}, red);
    mesh.colors.pop_back();
    EXPECT_TRUE(drawn({}, mesh, small()).pixels.empty());
}

}  // namespace
}  // namespace kushi
