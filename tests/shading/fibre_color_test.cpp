// SPDX-License-Identifier: Apache-2.0
#include <kushi/fibre.h>

#include <gtest/gtest.h>

namespace kushi {
namespace {

TEST(AbsorptionOfMelanin, IsThatOfTheTable) {
    const Rgb brown = absorptionOfMelanin(1.3F, 0);
    EXPECT_NEAR(brown.r, 0.5447, 1e-4);
    EXPECT_NEAR(brown.g, 0.9061, 1e-4);
    EXPECT_NEAR(brown.b, 1.7810, 1e-4);
    // Red hair: 0.15 of one, 1 of the other.
    const Rgb red = absorptionOfMelanin(1.15F, 1 / 1.15F);
    EXPECT_NEAR(red.r, 0.2499, 1e-4);
    EXPECT_NEAR(red.g, 0.5046, 1e-4);
    EXPECT_NEAR(red.b, 1.2555, 1e-4);
}

TEST(AbsorptionOfColor, IsTheFit) {
    // (ln 0.5 / 5.969)^2 without roughness.
    EXPECT_NEAR(absorptionOfColor({0.5F, 0.5F, 0.5F}, 0).g, 0.013485, 1e-5);
    // The polynomial at 1: 5.969 - 0.215 + 2.532 - 10.73 + 5.574 + 0.245 = 3.375.
    EXPECT_NEAR(absorptionOfColor({0.5F, 0.5F, 0.5F}, 1).b, 0.042180, 1e-5);
}

TEST(AbsorptionOfColor, ComesBack) {
    for (const double roughness : {0.1, 0.3, 0.9}) {
        const Rgb color = {0.9F, 0.2F, 0.01F};
        const Rgb back = colorOfAbsorption(absorptionOfColor(color, roughness), roughness);
        EXPECT_NEAR(back.r, color.r, 1e-5);
        EXPECT_NEAR(back.g, color.g, 1e-5);
        EXPECT_NEAR(back.b, color.b, 1e-6);
    }
}

TEST(AbsorptionOfColor, OfColoursOutOfRangeIsThatOfTheNearest) {
    EXPECT_EQ(absorptionOfColor({0, -1, 2}, 0.3), absorptionOfColor({0.001F, 0.001F, 0.99F}, 0.3));
}

}  // namespace
}  // namespace kushi
