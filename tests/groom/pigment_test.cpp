// SPDX-License-Identifier: Apache-2.0
#include <kushi/pigment.h>

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
    // (ln (0.475 / 0.975) / (0.705 * 5.969))^2 without roughness.
    EXPECT_NEAR(absorptionOfColor({0.5F, 0.5F, 0.5F}, 0).g, 0.029202, 1e-5);
    // The polynomial at 1: 5.969 - 0.215 + 2.532 - 10.73 + 5.574 + 0.245 = 3.375.
    EXPECT_NEAR(absorptionOfColor({0.5F, 0.5F, 0.5F}, 1).b, 0.091343, 1e-5);
}

TEST(AbsorptionOfColor, ComesBack) {
    for (const double roughness : {0.1, 0.3, 0.9}) {
        const Rgb color = {0.9F, 0.2F, 0.03F};
        const Rgb back = colorOfAbsorption(absorptionOfColor(color, roughness), roughness);
        EXPECT_NEAR(back.r, color.r, 1e-5);
        EXPECT_NEAR(back.g, color.g, 1e-5);
        EXPECT_NEAR(back.b, color.b, 1e-6);
    }
}

// A colour stands for the pigment that it is worked out from, also where it is all but black.
TEST(AbsorptionOfColor, OfWhatPigmentShowsIsThePigments) {
    for (const float melanin : {0.1F, 0.3F, 1.3F, 4.0F, 8.0F}) {
        const Rgb pigment = absorptionOfMelanin(melanin, 0.3F);
        const Rgb back = absorptionOfColor(colorOfAbsorption(pigment, 0.3), 0.3);
        EXPECT_NEAR(back.r / pigment.r, 1, 1e-4) << melanin;
        EXPECT_NEAR(back.g / pigment.g, 1, 1e-4) << melanin;
        // Blue is beyond what shows.
        if (melanin < 5) {
            EXPECT_NEAR(back.b / pigment.b, 1, 1e-4) << melanin;
        }
    }
}

TEST(AbsorptionOfColor, OfColoursOutOfRangeIsThatOfTheNearest) {
    EXPECT_EQ(absorptionOfColor({0, -1, 2}, 0.3), absorptionOfColor({0.025F, 0.02F, 0.99F}, 0.3));
}

}  // namespace
}  // namespace kushi
