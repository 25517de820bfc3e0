// SPDX-License-Identifier: Apache-2.0
#include "trace/pixel_filter.h"

#include "trace/test_scene.h"

#include <numbers>

#include <gtest/gtest.h>

namespace kushi {
namespace {

using namespace test;

/// The share of Blackman and Harris's window, three pixels wide, before x, by steps.
double shareBefore(double x) {
    constexpr int steps = 3000;
    double before = 0;
    double all = 0;
    for (int i = 0; i < steps; ++i) {
        const double at = 3 * (i + 0.5) / steps;
        const double angle = 2 * std::numbers::pi * at / 3;
        const double weight = 0.35875 - 0.48829 * std::cos(angle) + 0.14128 * std::cos(2 * angle) -
                              0.01168 * std::cos(3 * angle);
        all += weight;
        if (at - 1.5 < x) before += weight;
    }
    return before / all;
}

TEST(PixelFilter, PlacesSamplesAsTheWindowWeighs) {
    const PixelFilter filter;
    for (int i = 0; i <= 200; ++i) {
        const float random = std::min(static_cast<float>(i) / 200, 1 - 0x1p-24F);
        EXPECT_NEAR(shareBefore(static_cast<double>(filter.place(random))), random, 1e-3) << i;
        EXPECT_NEAR(filter.place(random), -filter.place(1 - random), 1e-3) << i;
    }
    EXPECT_GE(filter.place(0), -1.5F);
    EXPECT_LE(filter.place(1 - 0x1p-24F), 1.5F);
}

// A wall that ends between two pixels.
TEST(Trace, WeighsAnEdgeByThePixelFilter) {
    Mesh wall;
    wall.vertices = {{0, -9, 0}, {0, 9, 0}, {0, 9, 9}, {0, -9, 9}};
    wall.normals.assign(4, {1, 0, 0});
    wall.triangles = {{0, 1, 2}, {0, 2, 3}};
    TraceOptions options = small(1024);
    options.width = 12;
    options.height = 2;
    options.bounces = 0;
    const Result<Traced> traced =
        trace({}, wall, {}, onlyDome(), cameraAt({10, 0, 0}), whiteLook(), options);
    ASSERT_TRUE(traced.ok());
    double sum = 0;
    for (int x = 0; x < 12; ++x) {
        // z runs to the left here.
        const double share = shareBefore(6 - (x + 0.5));
        EXPECT_NEAR(traced->alpha[static_cast<std::size_t>(x)], share, 0.01) << x;
        sum += static_cast<double>(traced->alpha[static_cast<std::size_t>(x)]);
    }
    EXPECT_NEAR(sum, 6, 0.02);
}

}  // namespace
}  // namespace kushi
