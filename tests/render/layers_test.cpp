// SPDX-License-Identifier: Apache-2.0
#include "render/test_scene.h"

#include <kushi/draw.h>

#include <cmath>
#include <random>

#include <gmock/gmock.h>

namespace kushi {
namespace {

using namespace test;

constexpr Layers all = {.depth = true, .tangent = true, .strand = true, .mask = true};
constexpr Stroke strokes[] = {Stroke::Line, Stroke::Sampled, Stroke::Analytic};

LayeredImage layersOf(const Hairs& hairs, const Mesh& mesh, Stroke stroke, int size = 64,
                      const Layers& wanted = all) {
    const DrawOptions options = {.width = size, .height = size, .stroke = stroke};
    return drawLayers(hairs.strands, hairs.colors, mesh, pixelCamera(size), options, wanted);
}

std::size_t at(int x, int y, int size = 64) {
    return static_cast<std::size_t>(y * size + x);
}

/// One broad strand at the height y of the picture, from left to right and a metre nearer there.
Hairs slanting() {
    Hairs hairs;
    hairs.add({{50, 40, 0}, {60, 40, 0}}, white);  // out of the picture
    hairs.add({{-25, 0, 0}, {25, 0, 1}}, red);
    hairs.strands.diameters.assign(4, 6);
    return hairs;
}

TEST(Layers, HaveDepthAlongTheView) {
    for (const Stroke stroke : {Stroke::Sampled, Stroke::Analytic}) {
        const LayeredImage layers = layersOf(slanting(), {}, stroke);
        for (int x = 10; x < 54; ++x) {
            // Where the ray through the pixel meets the strand; samples reach 3/8 pixels further.
            const double slope = (x + 0.5 + 0.375 - 32) / 100;  // x over distance
            const double along = (slope * 100 + 25) / (50 + slope);
            EXPECT_NEAR(layers.depth[at(x, 31)], 100 - along, 2e-3) << x;
        }
        EXPECT_EQ(layers.depth[at(2, 2)], LayeredImage::nothing);
    }
}

TEST(Layers, HaveThePlaneOfACurtainAsDepth) {
    // A plane of strands that leans: z = 0.3 y - 0.2 x.
    Hairs hairs;
    for (int i = 0; i < 60; ++i) {
        const float x = static_cast<float>(i) - 29.5F;
        hairs.add({{x, 25, 7.5F - 0.2F * x}, {x, -25, -7.5F - 0.2F * x}}, red);
    }
    hairs.strands.diameters.assign(hairs.strands.nodes.size(), 1.3F);
    const LayeredImage layers = layersOf(hairs, {}, Stroke::Sampled);
    for (int y = 14; y < 50; ++y) {
        for (int x = 14; x < 50; ++x) {
            const double u = (x + 0.5 - 32) / 100;
            const double v = (32 - y - 0.5) / 100;
            // d = 100 - z, x = u d, y = v d.
            const double depth = 100 / (1 + 0.3 * v - 0.2 * u);
            EXPECT_NEAR(layers.depth[at(x, y)], depth, 0.45) << x << ' ' << y;
        }
    }
}

TEST(Layers, KnowWhichStrandIsSeen) {
    for (const Stroke stroke : {Stroke::Sampled, Stroke::Analytic}) {
        Hairs hairs;
        hairs.add({{-20, 3, 0}, {0, 3, 0}, {20, 3, 0}}, red);
        hairs.strands.add(std::vector<Vec3f>{{0, 0, 0}}, 7);  // a strand of one node counts too
        hairs.colors.push_back(black);
        hairs.add({{-20, -3, 0}, {0, -3, 0}, {20, -3, 0}}, red);
        hairs.add({{0, -20, 1}, {0, 20, 1}}, red);
        hairs.strands.diameters.assign(hairs.strands.nodes.size(), 4);
        const LayeredImage layers = layersOf(hairs, {}, stroke);
        EXPECT_EQ(layers.strand[at(20, 28)], 0U);
        EXPECT_EQ(layers.strand[at(44, 28)], 0U);
        EXPECT_EQ(layers.strand[at(20, 34)], 2U);
        EXPECT_EQ(layers.strand[at(32, 28)], 3U);
        EXPECT_EQ(layers.strand[at(5, 5)], LayeredImage::noStrand);
    }
}

TEST(Layers, NameTheStrandThatMostSamplesShow) {
    Hairs hairs;
    // A quarter of the pixel row for the nearer strand, three quarters for the other; then a half.
    hairs.add({{-20, 4.125F, 1}, {20, 4.125F, 1}}, red);
    hairs.add({{-20, 4.5F, 0}, {20, 4.5F, 0}}, red);
    hairs.strands.diameters = {0.25F, 0.25F, 1, 1};
    EXPECT_EQ(layersOf(hairs, {}, Stroke::Sampled).strand[at(32, 27)], 1U);
    hairs.strands.nodes[0].y = hairs.strands.nodes[1].y = 4.25F;
    hairs.strands.diameters = {0.5F, 0.5F, 1, 1};
    EXPECT_EQ(layersOf(hairs, {}, Stroke::Sampled).strand[at(32, 27)], 0U);
}

TEST(Layers, HaveTangentsFromRootToTip) {
    for (const Stroke stroke : strokes) {
        Hairs hairs;
        hairs.add({{20, 5.5F, 0}, {-20, 5.5F, 0}}, red);
        hairs.add({{-20, -5, -10}, {20, -5, 20}}, red);
        hairs.strands.diameters.assign(4, 4);
        const LayeredImage layers = layersOf(hairs, {}, stroke);
        const Vec3f level = layers.tangent[at(32, 26)];
        EXPECT_NEAR(level.x, -1, 1e-6);
        const Vec3f slanting = layers.tangent[at(32, 37)];
        EXPECT_NEAR(slanting.x, 0.8, 1e-6);
        EXPECT_NEAR(slanting.z, 0.6, 1e-6);
        EXPECT_EQ(layers.tangent[at(3, 3)], Vec3f{});
    }
}

TEST(Layers, MeanTangentsAreUnitVectors) {
    Hairs hairs;
    // Half of a pixel each: at right angles, and against each other.
    hairs.add({{-20, 4.25F, 0}, {20, 4.25F, 0}}, red);
    hairs.add({{-20, 4.75F, -20}, {20, 4.75F, 20}}, red);
    hairs.add({{-20, -4.25F, 0.5F}, {20, -4.25F, 0.5F}}, red);
    hairs.add({{20, -4.75F, 0}, {-20, -4.75F, 0}}, red);
    hairs.strands.diameters.assign(8, 0.5F);
    const LayeredImage layers = layersOf(hairs, {}, Stroke::Sampled);
    const Vec3f mean = layers.tangent[at(32, 27)];
    EXPECT_NEAR(std::atan2(mean.z, mean.x), radians(22.5), 1e-5);
    EXPECT_NEAR(length(mean), 1, 1e-6);
    EXPECT_EQ(layers.tangent[at(32, 36)], (Vec3f{1, 0, 0}));  // the nearer one's
}

TEST(Layers, SayHowMuchIsHairAndHowMuchIsAnything) {
    Mesh head;
    addRectangle(head, {-20, -20, -1}, {0, 20, -1}, blue);
    Hairs hairs;
    hairs.add({{-30, 4.5F, 0}, {30, 4.5F, 0}}, red);
    hairs.strands.diameters.assign(2, 0.5F);
    for (const Stroke stroke : {Stroke::Sampled, Stroke::Analytic}) {
        const LayeredImage layers = layersOf(hairs, head, stroke);
        const auto expect = [&](int x, int y, double alpha, double mask) {
            EXPECT_NEAR(layers.alpha[at(x, y)], alpha, 2e-3) << x << ' ' << y;
            EXPECT_NEAR(layers.mask[at(x, y)], mask, 2e-3) << x << ' ' << y;
        };
        expect(50, 27, 0.5, 0.5);
        expect(20, 27, 1, 0.5);
        expect(20, 40, 1, 0);
        expect(50, 40, 0, 0);
        EXPECT_NEAR(layers.depth[at(20, 40)], 101, 1e-3);
        EXPECT_NEAR(layers.depth[at(20, 27)], 100, 1e-3);
    }
}

TEST(Layers, GiveThePictureOverAnyBackground) {
    std::mt19937 random(3);
    std::uniform_real_distribution<float> place(-30, 30);
    Hairs hairs;
    for (int i = 0; i < 300; ++i)
        hairs.add({{place(random), place(random), 0}, {place(random), place(random), 1}}, green);
    hairs.strands.diameters.assign(600, 0.4F);
    Mesh head;
    addRectangle(head, {-20, -20, 0.5F}, {0, 20, 0.5F}, blue);
    for (const Stroke stroke : strokes) {
        DrawOptions options = {
            .width = 64, .height = 64, .background = {0.5F, 0.7F, 0.2F}, .stroke = stroke};
        const Image image = drawn(hairs, head, options);
        const LayeredImage layers = layersOf(hairs, head, stroke, 64, {});
        EXPECT_TRUE(layers.depth.empty() && layers.tangent.empty());
        EXPECT_TRUE(layers.strand.empty() && layers.mask.empty());
        for (std::size_t i = 0; i < image.pixels.size(); ++i) {
            const Rgb over = layers.image.pixels[i] + options.background * (1 - layers.alpha[i]);
            ASSERT_NEAR(over.r, image.pixels[i].r, 1e-5);
            ASSERT_NEAR(over.g, image.pixels[i].g, 1e-5);
            ASSERT_NEAR(over.b, image.pixels[i].b, 1e-5);
        }
    }
}

TEST(Layers, AreEmptyWhereNothingCanBeDrawn) {
    const DrawOptions options = {.width = 0};
    const std::vector<Rgb> none;
    EXPECT_TRUE(drawLayers({}, none, {}, pixelCamera(64), options, all).image.pixels.empty());
}

}  // namespace
}  // namespace kushi
