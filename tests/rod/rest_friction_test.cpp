// SPDX-License-Identifier: Apache-2.0
#include "rod/analytic_field.h"
#include "rod/rest_rods.h"

#include <gtest/gtest.h>

namespace kushi {
namespace {

// A hair of 20 cm that is laid level across a slope, and what becomes of it.
struct Laid {
    double down = 0;  // of the tip, along the slope [m]
    bool settled = false;
};

Laid laidAcross(double slope, double friction, double share = 1) {
    const Vec3d normal = {-std::sin(slope), std::cos(slope), 0};
    // The root lies just inside the skin.
    DistanceField solid =
        rest::sampled({-0.3, -0.3, -0.05}, {0.3, 0.3, 0.35}, 0.0025,
                      [&](Vec3d at) { return dot(at, normal) + 0.95 * contactSkin; });
    // Two solids: the one in question is the second.
    solid.nearest.assign(solid.units.size(), 1);
    const float frictions[] = {static_cast<float>(2 * share), static_cast<float>(friction)};
    Rods rods;
    rest::addRod(rods, frameAlong({0, 0, 1}), 0, 25);
    rods.lengths[0] = 0.2F;
    rods.bending[0] = 6.06e-9F;
    rods.twisting[0] = 4.04e-9F;
    rods.weights[0] = 5.72e-5F;
    RodWorld world;
    world.solids = &solid;
    world.solidFrictions = frictions;
    const rest::Settled settled = rest::settle(rods, world);
    const Vec3d tip = settled.tip(rods, 0).as<double>();
    return {-dot(tip, Vec3d{std::cos(slope), std::sin(slope), 0}), settled.states[0] != 0};
}

TEST(RestFriction, HoldsHairOnASlopeBelowTheAngleOfFrictionAndLetsItSlideAbove) {
    for (const double slope : {radians(20), radians(35)}) {
        for (const double held : {1.3, 2.0}) {
            const Laid laid = laidAcross(slope, held * std::tan(slope));
            EXPECT_TRUE(laid.settled);
            EXPECT_LT(std::abs(laid.down), 1e-3) << held;
        }
        for (const double slides : {0.0, 0.5, 0.95}) {
            const Laid laid = laidAcross(slope, slides * std::tan(slope));
            EXPECT_TRUE(laid.settled);
            EXPECT_GT(laid.down, 0.1) << slides;
        }
    }
}

TEST(RestFriction, IsThatOfTheSolidWhichIsTouched) {
    EXPECT_GT(laidAcross(radians(20), 0, 1).down, 0.1);
    EXPECT_LT(std::abs(laidAcross(radians(20), 1, 0).down), 1e-3);
}

}  // namespace
}  // namespace kushi
