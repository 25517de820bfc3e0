// SPDX-License-Identifier: Apache-2.0
// One hair, so near that it fills the picture, against the integral of its response.
#include "shading/strand_tilt.h"
#include "trace/test_scene.h"

#include <numbers>
#include <numeric>

#include <gtest/gtest.h>

namespace kushi {
namespace {

using namespace test;

constexpr double pi = std::numbers::pi;

/// Directions about a hair with this tangent.
FibreDirection about(Vec3d tangent, Vec3d direction) {
    const Vec3d x = normalized(cross(Vec3d{0.3, 0.5, -0.8}, tangent));
    const Vec3d y = cross(tangent, x);
    return {std::asin(dot(direction, tangent)), std::atan2(dot(direction, y), dot(direction, x))};
}

/// What the light sends to the eye from a place on the hair whose surface is turned to `normal`.
double radiance(const Fibre& fibre, double absorption, Vec3d tangent, Vec3d normal, Vec3d toEye,
                const Light& light) {
    const FibreDirection out = about(tangent, toEye);
    const double h = std::sin(out.phi - about(tangent, normal).phi);
    const Vec3d middle = light.direction.as<double>();
    const Vec3d x = normalized(cross(middle, Vec3d{0.1, 0.9, 0.2}));
    const Vec3d y = cross(middle, x);
    constexpr int rings = 12;
    double sum = 0;
    for (int i = 0; i < rings; ++i) {
        for (int j = 0; j < 2 * rings; ++j) {
            const double low = (1 - std::cos(light.halfAngle)) * (i + 0.5) / rings;
            const double sine = std::sqrt(low * (2 - low));
            const double turn = pi * (j + 0.5) / rings;
            const Vec3d in = (1 - low) * middle + sine * (std::cos(turn) * x + std::sin(turn) * y);
            const FibreLobes lobes = fibreResponse(fibre, absorption, h, out, about(tangent, in));
            sum += std::accumulate(lobes.begin(), lobes.end(), 0.0);
        }
    }
    // A white surface square to the light gets its colour, so that its cosines add up to pi of it.
    const double mean = sum / (2 * rings * rings);
    return mean * light.color.r * 2 * pi * (1 - std::cos(light.halfAngle)) /
           (std::sin(light.halfAngle) * std::sin(light.halfAngle));
}

/// Blackman and Harris's window at so many pixels from a pixel's middle; not normalised.
double window(double pixels) {
    const double angle = 2 * pi * pixels / 3;
    return 0.35875 + 0.48829 * std::cos(angle) + 0.14128 * std::cos(2 * angle) +
           0.01168 * std::cos(3 * angle);
}

TEST(Trace, ShowsOneHairAsTheModelHasIt) {
    Fibre fibre;
    const Rgb color = {0.6F, 0.3F, 0.1F};
    const Vec3d tangent = normalized(Vec3d{0.15, 1, 0.1});
    Strands strands;
    const std::vector<Vec3f> nodes = {(-0.4 * tangent).as<float>(), (-0.1 * tangent).as<float>(),
                                      (0.3 * tangent).as<float>()};
    strands.add(nodes, 1);
    constexpr double diameter = 0.04;
    TraceLook look;
    look.fibre = fibre;
    fibre.tilt += static_cast<double>(look.tiltVariation * strandTilt(strands, 0));
    look.color = color;
    look.diameter = static_cast<float>(diameter);
    const Camera camera = {.eye = {0, 0, 10},
                           .target = {},
                           .verticalFieldOfView = 0.004F};  // 40 mm are the whole height
    TraceOptions options = small(1024);
    options.width = 21;
    options.height = 21;
    options.bounces = 1;
    const double absorption = static_cast<double>(absorptionOfColor(color, fibre.azimuthal).r);
    for (const Vec3f towards : {Vec3f{0.8F, 0.05F, 0.7F}, Vec3f{-0.5F, 0.2F, -1},
                                Vec3f{0.2F, -0.2F, 1}, Vec3f{-0.9F, 0, 0.1F}}) {
        const Light light = {normalized(towards), {2, 2, 2}, 0.12F};
        const Lights lights = {.ambient = black, .distant = {light}};
        const Result<Traced> traced = trace(strands, {}, {}, lights, camera, look, options);
        ASSERT_TRUE(traced.ok());
        double sum = 0;
        double difference = 0;
        for (int x = 1; x < 20; ++x) {
            // Mean by the pixel filter's weights, in the middle row.
            double truth = 0;
            double weights = 0;
            constexpr int steps = 48;
            for (int i = 0; i < steps; ++i) {
                const double off = 3 * (i + 0.5) / steps - 1.5;
                const double right = (x + 0.5 + off - 10.5) / 21 * 0.04;
                const Vec3d toEye = normalized(Vec3d{-right, 0, 10});
                // The hair's surface where the eye sees it at `right`.
                const Vec3d across = normalized(cross(tangent, toEye));
                const double h =
                    std::clamp(dot(across, Vec3d{right, 0, 0}) / (diameter / 2), -1.0, 1.0);
                const Vec3d facing = cross(across, tangent);
                const Vec3d normal = h * across + std::sqrt(1 - h * h) * facing;
                truth += window(off) * radiance(fibre, absorption, tangent, normal, toEye, light);
                weights += window(off);
            }
            truth /= weights;
            const double found = traced->image.at(x, 10).r;
            sum += truth;
            difference += std::abs(found - truth);
        }
        EXPECT_LT(difference, 0.03 * sum) << towards.x;
    }
}

/// The mean picture of one hair with this key.
Rgb oneHair(std::uint64_t key, const TraceLook& look) {
    Strands strands;
    strands.add(std::vector<Vec3f>{{0, -0.02F, 0}, {0, 0.02F, 0}}, key);
    const Lights lights = {.ambient = black, .distant = {{{0.2F, 0.3F, 1}, white, 0.05F}}};
    const Camera camera = {.eye = {0, 0, 10}, .target = {}, .verticalFieldOfView = 0.001F};
    TraceOptions options = small(64);
    options.bounces = 1;
    return meanOf(trace(strands, {}, {}, lights, camera, look, options)->image);
}

TEST(Trace, TiltsTheScalesOfEachStrandByItsKey) {
    TraceLook look;
    look.color = black;
    look.diameter = 0.02F;
    look.tiltVariation = 0.1F;
    Strands keys;
    double mean = 0;
    for (std::uint64_t key = 1; key <= 1000; ++key) {
        keys.add(std::vector<Vec3f>{{}, {0, 1, 0}}, key);
        mean += static_cast<double>(strandTilt(keys, keys.size() - 1)) / 1000;
    }
    EXPECT_NEAR(mean, 0, 4 / std::sqrt(3.0 * 1000));
    const float one = oneHair(1, look).g;
    const float other = oneHair(2, look).g;
    EXPECT_GT(std::abs(one - other), 0.05F * one);
    // As a fibre of that tilt and no variation.
    for (const std::size_t i : {0U, 1U}) {
        TraceLook same = look;
        same.tiltVariation = 0;
        same.fibre.tilt += static_cast<double>(look.tiltVariation * strandTilt(keys, i));
        const float truth = oneHair(7, same).g;
        EXPECT_NEAR(i == 0 ? one : other, truth, 1e-3F * truth);
    }
}

}  // namespace
}  // namespace kushi
