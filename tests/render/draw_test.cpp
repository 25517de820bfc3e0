// SPDX-License-Identifier: Apache-2.0
#include "render/test_scene.h"

#include <kushi/draw.h>

#include <random>

#include <gmock/gmock.h>

namespace kushi {
namespace {

using namespace test;

DrawOptions small(int supersample = 1) {
    return {.width = 80, .height = 60, .supersample = supersample, .background = black};
}

void expectNear(Rgb a, Rgb b, double tolerance) {
    EXPECT_NEAR(a.r, b.r, tolerance);
    EXPECT_NEAR(a.g, b.g, tolerance);
    EXPECT_NEAR(a.b, b.b, tolerance);
}

TEST(Draw, ShowsTheBackgroundWhereThereIsNothing) {
    for (const int supersample : {1, 2, 4}) {
        const DrawOptions options = {.width = 70, .height = 130, .supersample = supersample};
        const Image image = drawn({}, {}, options);
        EXPECT_EQ(image.width, 70);
        EXPECT_EQ(image.height, 130);
        ASSERT_EQ(image.pixels.size(), 70U * 130U);
        for (const Rgb pixel : image.pixels)
            ASSERT_EQ(pixel, options.background);
    }
}

TEST(Draw, PutsThingsWhereTheCameraSeesThem) {
    Hairs hairs;
    hairs.add({{-30.5F, 20.5F, 0}, {-27.5F, 20.5F, 0}}, red);
    const Image image = drawn(hairs, {}, small());
    // The middle of the picture is at (40, 30); up is towards lower rows.
    EXPECT_EQ(image.at(10, 9), red);
    EXPECT_EQ(image.at(11, 9), red);
    EXPECT_NEAR(redOf(image), 3, 1);
}

TEST(Draw, GivesALineItsLengthAsEnergyWhateverItsPlaceAndSlope) {
    std::mt19937 random(1);
    std::uniform_real_distribution<float> place(-3, 3);
    for (const int supersample : {1, 4}) {
        for (int degree = 0; degree < 180; degree += 5) {
            const double angle = radians(degree);
            const Vec3f arm = Vec3d{24 * std::cos(angle), 24 * std::sin(angle), 0}.as<float>();
            const Vec3f middle = {place(random), place(random), 0};
            Hairs hairs;
            hairs.add({middle - arm, middle + arm}, white);
            // A sample is 1 / supersample^2 of a pixel and the line 48 supersample of them long.
            const double expected = 48.0 / supersample;
            EXPECT_NEAR(redOf(drawn(hairs, {}, small(supersample))), expected,
                        2.5 / (supersample * supersample))
                << degree;
        }
    }
}

TEST(Draw, GivesAPolylineItsLengthTooHoweverFinelyItIsCut) {
    for (const int segments : {1, 3, 20, 200, 3000}) {
        Hairs hairs;
        std::vector<Vec3f> nodes;
        for (int i = 0; i <= segments; ++i) {
            const float t = static_cast<float>(i) / static_cast<float>(segments);
            nodes.push_back({-35.3F + 70 * t, -20.1F + 40 * t, 0});
        }
        hairs.add(nodes, white);
        EXPECT_NEAR(redOf(drawn(hairs, {}, small())), std::hypot(70, 40), 2.5) << segments;
    }
}

TEST(Draw, HidesWhatLiesBehindTheHead) {
    Mesh head;
    addRectangle(head, {-20, -20, 0}, {20, 20, 0}, blue);
    Hairs hairs;
    hairs.add({{-30, 4.5F, 0.01F}, {30, 4.5F, 0.01F}}, red);
    hairs.add({{-30, -5.5F, -0.01F}, {30, -5.5F, -0.01F}}, green);
    const Image image = drawn(hairs, head, small());
    EXPECT_EQ(image.at(40, 25), red);
    EXPECT_EQ(image.at(40, 35), blue);
    EXPECT_EQ(image.at(12, 35), green);
    EXPECT_EQ(image.at(40, 30), blue);
}

TEST(Draw, ShowsTheNearerOfTwoHairs) {
    for (const float z : {0.001F, -0.001F}) {
        Hairs hairs;
        hairs.add({{-30, 0.5F, 0}, {30, 0.5F, 0}}, red);
        hairs.add({{0.5F, -20, z}, {0.5F, 20, z}}, green);
        EXPECT_EQ(drawn(hairs, {}, small()).at(40, 29), z > 0 ? green : red);
    }
}

TEST(Draw, LetsTheFirstWinAtEqualDepth) {
    Mesh head;
    addRectangle(head, {-20, -20, 0}, {20, 20, 0}, blue);
    Hairs hairs;
    hairs.add({{-30, 0.5F, 0}, {30, 0.5F, 0}}, red);
    hairs.add({{-30, 0.5F, 0}, {30, 0.5F, 0}}, green);
    const Image image = drawn(hairs, head, small());
    for (int x = 15; x < 65; ++x)
        EXPECT_EQ(image.at(x, 29), red) << x;
}

TEST(Draw, InterpolatesColorAlongASegment) {
    Hairs hairs;
    hairs.add({{-30, 0.5F, 0}, {30, 0.5F, 0}}, {red, blue});
    const Image image = drawn(hairs, {}, small());
    for (int x = 11; x < 69; ++x) {
        const auto t = static_cast<float>((x + 0.5 - 10) / 60);
        expectNear(image.at(x, 29), {1 - t, 0, t}, 1e-5);
    }
}

TEST(Draw, InterpolatesColorInSpaceNotOnThePicture) {
    // From 50 m before the camera to 200 m: at half of the way on the picture only a fifth in
    // space.
    Hairs hairs;
    hairs.add({{-15, 0.25F, 50}, {60, 1, -100}}, {red, blue});
    const Image image = drawn(hairs, {}, small());
    for (int x = 11; x < 69; ++x) {
        const double s = (x + 0.5 - 10) / 60;
        const auto t = static_cast<float>(s * 50 / ((1 - s) * 200 + s * 50));
        expectNear(image.at(x, 29), {1 - t, 0, t}, 1e-4);
    }
}

TEST(Draw, InterpolatesColorOverATriangleInSpace) {
    // A square that leans away, 50 m to 200 m off, and as wide on the picture there as here.
    Mesh mesh;
    mesh.vertices = {{-10, -10, 50}, {10, -10, 50}, {40, 40, -100}, {-40, 40, -100}};
    mesh.colors = {red, red, blue, blue};
    mesh.triangles = {{0, 1, 2}, {0, 2, 3}};
    const Image image = drawn({}, mesh, small());
    for (int y = 11; y < 49; ++y) {
        const double s = (50 - (y + 0.5)) / 40;
        const auto t = static_cast<float>(s * 50 / ((1 - s) * 200 + s * 50));
        for (const int x : {21, 33, 58})
            expectNear(image.at(x, y), {1 - t, 0, t}, 1e-4);
    }
}

TEST(Draw, DrawsAMeshWithoutColorsGrey) {
    Mesh mesh;
    addRectangle(mesh, {-20, -20, 0}, {20, 20, 0}, blue);
    mesh.colors.clear();
    expectNear(drawn({}, mesh, small()).at(40, 30), {0.5F, 0.5F, 0.5F}, 1e-6);
}

TEST(Draw, AveragesSamplesInLinearLight) {
    Mesh mesh;
    addRectangle(mesh, {-20, -20, 0}, {0.5F, 10.25F, 0}, white);
    const Image image = drawn({}, mesh, small(4));
    EXPECT_FLOAT_EQ(image.at(39, 30).r, 1);
    EXPECT_FLOAT_EQ(image.at(40, 30).r, 0.5F);
    EXPECT_FLOAT_EQ(image.at(39, 19).r, 0.25F);
    EXPECT_FLOAT_EQ(image.at(40, 19).r, 0.125F);
    EXPECT_FLOAT_EQ(image.at(41, 30).r, 0);
}

TEST(Draw, AgreesWithItselfAtAnyNumberOfSamples) {
    Mesh mesh = ellipsoidMesh({.center = {2.3, -1.7, 0}, .semiAxes = {25, 15, 5}}, 20);
    mesh.colors.assign(mesh.vertices.size(), white);
    const double area = std::numbers::pi * 25 * 15;
    for (const int supersample : {1, 2, 4}) {
        EXPECT_NEAR(redOf(drawn({}, mesh, small(supersample))), area, 0.01 * area) << supersample;
    }
}

TEST(Draw, FillsTheWholePictureWhateverItsSize) {
    for (const auto& [width, height] : {std::pair{1, 1}, {65, 63}, {130, 1}, {3, 200}, {64, 128}}) {
        Mesh mesh;
        addRectangle(mesh, {-200, -200, 0}, {200, 200, 0}, red);
        for (const int supersample : {1, 2, 4}) {
            const Image image =
                drawn({}, mesh, {.width = width, .height = height, .supersample = supersample});
            for (const Rgb pixel : image.pixels)
                expectNear(pixel, red, 1e-5);
        }
    }
}

TEST(Draw, KeepsHairAMillimetreAboveTheHeadInSight) {
    Mesh head = ellipsoidMesh({.center = {}, .semiAxes = {0.1, 0.1, 0.1}}, 71);
    head.colors.assign(head.vertices.size(), blue);
    const Camera camera = frame(boundsOf(head.vertices), {}, 1);
    const auto redWith = [&](double radius, const Mesh& mesh) {
        Hairs hairs;
        for (int i = 0; i < 200; ++i) {
            std::vector<Vec3f> nodes;
            for (int j = 0; j <= 100; ++j) {
                const double theta = radians(30 + 1.2 * j);
                const double phi = radians(-60 + 0.6 * i);
                nodes.push_back(Vec3d{radius * std::sin(theta) * std::cos(phi),
                                      radius * std::cos(theta),
                                      radius * std::sin(theta) * std::sin(phi)}
                                    .as<float>());
            }
            hairs.add(nodes, red);
        }
        const DrawOptions options = {
            .width = 256, .height = 256, .supersample = 2, .background = black};
        return redOf(draw(hairs.strands, hairs.colors, mesh, camera, options));
    };
    EXPECT_GT(redWith(0.101, head), 5000);
    EXPECT_NEAR(redWith(0.101, head), redWith(0.101, {}), 1e-3);
    EXPECT_EQ(redWith(0.099, head), 0);
}

}  // namespace
}  // namespace kushi
