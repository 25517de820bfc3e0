// SPDX-License-Identifier: Apache-2.0
// Light is neither made nor lost.
#include "trace/test_scene.h"

#include <algorithm>

#include <gtest/gtest.h>

namespace kushi {
namespace {

using namespace test;

const Vec3f eye = {1.2F, 0.5F, 1};

TraceOptions deep(int samples) {
    TraceOptions options = small(samples);
    options.bounces = 10000;
    options.background = white;
    return options;
}

// White furnace: under a white sky, what takes no light is as bright as the sky, everywhere.
TEST(Trace, ShowsNothingOfClearHairAndAWhiteHeadUnderAWhiteSky) {
    const Mesh head = ball();
    const std::vector<Rgb> skin(head.vertices.size(), white);
    for (const float diameter : {0.2e-3F, 1e-3F, 4e-3F}) {  // pixels are 7 mm wide
        for (const double roughness : {0.15, 0.3, 0.8}) {
            TraceLook look = whiteLook();
            look.diameter = diameter;
            look.fibre.longitudinal = roughness;
            look.fibre.azimuthal = roughness;
            const Result<Traced> traced =
                trace(hairsOnBall(1200), head, skin, onlyDome(), cameraAt(eye), look, deep(64));
            ASSERT_TRUE(traced.ok());
            for (const Rgb pixel : traced->image.pixels)
                ASSERT_NEAR(pixel.g, 1, 0.01) << diameter << " " << roughness;
            EXPECT_NEAR(meanOf(traced->image).b, 1, 1e-3);
        }
    }
}

// A sky all of discs is a sky too.
TEST(Trace, FindsTheLightOfWideDiscs) {
    Lights lights = onlyDome(black);
    for (const float side : {1.0F, -1.0F}) {
        // A hemisphere that gives a surface square to it its colour has a radiance of that.
        lights.distant.push_back({{0, side, 0}, white, static_cast<float>(radians(90))});
    }
    const Mesh head = ball();
    const std::vector<Rgb> skin(head.vertices.size(), white);
    const Result<Traced> traced =
        trace(hairsOnBall(800), head, skin, lights, cameraAt(eye), whiteLook(), deep(512));
    ASSERT_TRUE(traced.ok());
    EXPECT_NEAR(meanOf(traced->image).g, 1, 0.01);
}

TEST(Trace, NeverSendsOnMoreThanArrives) {
    const Mesh head = ball();
    const std::vector<Rgb> skin(head.vertices.size(), white);
    TraceLook look = whiteLook();
    look.skinGloss = 0.2F;
    TraceOptions options = deep(64);
    float before = 0;
    for (const int bounces : {0, 1, 2, 5, 30}) {
        options.bounces = bounces;
        const Result<Traced> traced =
            trace(hairsOnBall(1200), head, skin, onlyDome(), cameraAt(eye), look, options);
        ASSERT_TRUE(traced.ok());
        const float mean = meanOf(traced->image).g;
        EXPECT_GT(mean, before) << bounces;
        EXPECT_LT(mean, 1) << bounces;
        before = mean;
    }
}

TEST(Trace, LightsMattSkinAsDistantLightsSay) {
    // A wall square to the light and the eye.
    Mesh wall;
    wall.vertices = {{0, -1, -1}, {0, 1, -1}, {0, 1, 1}, {0, -1, 1}};
    wall.normals.assign(4, {1, 0, 0});
    wall.triangles = {{0, 1, 2}, {0, 2, 3}};
    const std::vector<Rgb> skin(4, {0.5F, 0.25F, 1});
    const Lights lights = {.ambient = {0.1F, 0.2F, 0.3F}, .distant = {{{1, 0, 0}, {2, 1, 0.5F}}}};
    TraceOptions options = small(256);
    const Result<Traced> traced =
        trace({}, wall, skin, lights, cameraAt({3, 0, 0}), whiteLook(), options);
    ASSERT_TRUE(traced.ok());
    const Rgb mean = meanOf(traced->image);
    EXPECT_NEAR(mean.r, 0.5 * 2.1, 2e-3);
    EXPECT_NEAR(mean.g, 0.25 * 1.2, 1e-3);
    EXPECT_NEAR(mean.b, 1 * 0.8, 2e-3);
}

// A strand before a light leaves its shadow on a wall, as dark as it hides the light's disc.
TEST(Trace, LetsHairThrowSoftShadows) {
    Mesh wall;
    wall.vertices = {{0, -1, -1}, {0, 1, -1}, {0, 1, 1}, {0, -1, 1}};
    wall.normals.assign(4, {1, 0, 0});
    wall.triangles = {{0, 1, 2}, {0, 2, 3}};
    const std::vector<Rgb> skin(4, white);
    Strands strands;
    // Ten cm before the wall, the light's disc is 10 mm wide from there; the hair hides 1 mm of it,
    // out of the camera's sight, which looks from the side.
    strands.add(std::vector<Vec3f>{{0.1F, 0, -0.9F}, {0.1F, 0, 0.9F}}, 1);
    Lights lights = onlyDome(black);
    lights.distant = {{{1, 0, 0}, white, 0.05F}};
    TraceLook look = whiteLook();
    look.diameter = 1e-3F;
    look.color = black;
    TraceOptions options = small(4096);
    options.width = 9;
    options.height = 9;
    options.bounces = 1;
    const Camera camera = {.eye = {3, 2, 0}, .target = {}, .verticalFieldOfView = 2e-4F};
    const Result<Traced> traced = trace(strands, wall, skin, lights, camera, look, options);
    ASSERT_TRUE(traced.ok());
    // A strip 1 mm wide across the middle of a disc of radius 5 mm: 1 * 10 / (pi 25).
    EXPECT_NEAR(meanOf(traced->image).g, 1 - 10 / (3.14159 * 25), 0.005);
}

}  // namespace
}  // namespace kushi
