// SPDX-License-Identifier: Apache-2.0
#include "shading/far_field.h"

#include <numbers>

#include <gtest/gtest.h>

namespace kushi {
namespace {

constexpr float pi = std::numbers::pi_v<float>;

TEST(FarField, AClearFibreSendsOnAllAround) {
    const FarField far({.longitudinal = 0.2, .azimuthal = 0.3});
    for (const float sinHalf : {0.0F, 0.3F, 0.7F, 0.95F}) {
        double sum = 0;
        double halves = 0;
        constexpr int steps = 720;
        for (int i = 0; i < steps; ++i) {
            const float phi = pi * (static_cast<float>(i) + 0.5F) / steps;
            const FarField::Around around = far.around(sinHalf, phi);
            sum += 2 * pi / steps * (around.r + around.tt + around.trt);
            halves += 2 * pi / steps * (around.rHalf + around.ttHalf + around.trtHalf);
        }
        EXPECT_NEAR(sum, 1, 0.01) << sinHalf;
        EXPECT_NEAR(halves, 1, 0.02) << sinHalf;
    }
}

TEST(FarField, IsTheMeanOverTheFibresWidth) {
    const Fibre fibre = {.longitudinal = 0.2, .azimuthal = 0.3};
    const FarField far(fibre);
    // Directions in the normal plane; M of each lobe is taken out again by the sum over theta.
    for (const double absorption : {0.0, 0.25, 1.0}) {
        for (const float phi : {0.0F, 0.8F, 2.2F, 3.14F}) {
            double mean = 0;
            constexpr int across = 200;
            for (int i = 0; i < across; ++i) {
                const double gamma = -pi / 2 + (i + 0.5) * std::numbers::pi / across;
                constexpr int along = 60;
                for (int j = 0; j < along; ++j) {
                    const double theta = -pi / 2 + (j + 0.5) * std::numbers::pi / along;
                    const FibreLobes lobes =
                        fibreResponse(fibre, absorption, std::sin(gamma), {0, 0}, {theta, phi});
                    mean += 0.5 * std::cos(gamma) * std::cos(theta) * std::numbers::pi / across *
                            std::numbers::pi / along * (lobes[0] + lobes[1] + lobes[2] + lobes[3]);
                }
            }
            const FarField::Around around = far.around(0, phi);
            const double sum = around.r + around.tt * std::exp(-absorption * around.pathTt) +
                               around.trt * std::exp(-absorption * around.pathTrt);
            EXPECT_NEAR(sum, mean, 0.06 * mean + 1e-3) << absorption << " at " << phi;
        }
    }
}

// The shares of light that go on and back, of the table of directional albedos at theta 0.
TEST(FarField, ShareThatGoesOnAndBack) {
    const FarField far({.azimuthal = 0.3});
    const struct {
        float absorption, all, forward;
    } cases[] = {{0, 1, 0.9028F},
                 {0.1257F, 0.796F, 0.7216F},
                 {0.5447F, 0.3962F, 0.3524F},
                 {1.781F, 0.1071F, 0.0726F}};
    for (const auto& [absorption, all, forward] : cases) {
        const FarField::Albedo albedo = far.albedo(absorption);
        // Ours is a mean over slanting light too.
        EXPECT_NEAR(albedo.forward, forward, 0.035) << absorption;
        EXPECT_NEAR(albedo.forward + albedo.backward, all, 0.035) << absorption;
    }
}

TEST(FarField, APileOfClearFibresSendsAllBack) {
    const FarField far({.azimuthal = 0.3});
    const FarField::Albedo clear = far.albedo(0);
    EXPECT_NEAR(clear.backward + clear.local, 1, 0.02);
    // For blond red light and for brown (rendering of a stack without end).
    EXPECT_NEAR(far.albedo(0.126F).local, 0.0828, 0.03);
    EXPECT_NEAR(far.albedo(0.545F).local, 0.0062, 0.004);
    EXPECT_LT(far.albedo(1e6F).local, 1e-3);
}

}  // namespace
}  // namespace kushi
