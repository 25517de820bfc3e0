// SPDX-License-Identifier: Apache-2.0
#include "style/ranges.h"

#include <kushi/cantilever.h>

#include <gtest/gtest.h>

namespace kushi {
namespace {

constexpr double pi = std::numbers::pi;

Force force(Vec3d direction, double magnitude, Box within = {}) {
    Force f;
    f.direction.vector = direction;
    f.magnitude = magnitude;
    f.within = within;
    return f;
}

TEST(Load, AddsGravityAndEveryForceWhoseBoxHoldsThePlace) {
    const Force side = force({0, 0, 1}, 0.5, {{}, {0, 0.1}, {}});
    const Force back = force({-1, 0, 0}, -2);
    const std::vector<ActiveForce> active = {{&side, 1}, {&back, 1}};
    CantileverWorld world;
    world.forces = active;
    EXPECT_EQ(loadAt(world, {0, 0.1, 0}), (Vec3d{2, -1, 0.5}));
    EXPECT_EQ(loadAt(world, {0, 0.1001, 0}), (Vec3d{2, -1, 0}));
    EXPECT_EQ(loadAt(world, {0, -0.0001, 0}), (Vec3d{2, -1, 0}));
}

TEST(Load, RadialPointsHorizontallyAwayFromTheVerticalAxis) {
    Force f = force({}, -2);
    f.direction.radial = true;
    const std::vector<ActiveForce> active = {{&f, 0.5}};
    CantileverWorld world;
    world.gravity = {};
    world.forces = active;
    const Vec3d load = loadAt(world, {0.3, 7, -0.4});
    EXPECT_NEAR(load.x, -0.6, 1e-15);
    EXPECT_EQ(load.y, 0);
    EXPECT_NEAR(load.z, 0.8, 1e-15);
    EXPECT_EQ(loadAt(world, {0, 7, 0}), Vec3d{});
}

TEST(RootRange, IsClosedAndMayRunPastHalfATurn) {
    const RootRange back = {{radians(10), radians(90)}, {radians(90), radians(270)}};
    EXPECT_TRUE(contains(back, {radians(10), radians(90)}));
    EXPECT_TRUE(contains(back, {radians(90), radians(-91)}));
    EXPECT_TRUE(contains(back, {radians(50), radians(-180)}));
    EXPECT_FALSE(contains(back, {radians(50), radians(-89)}));
    EXPECT_FALSE(contains(back, {radians(50), 0}));
    EXPECT_FALSE(contains(back, {radians(91), radians(180)}));
    EXPECT_TRUE(contains(RootRange{}, {3, 3}));
}

TEST(Falloff, IsARampCentredOnTheEdge) {
    const RootRange right = {{0, pi / 2}, {0, pi}};
    const double width = radians(10);
    EXPECT_NEAR(share(right, {1, 0}, width), 0.5, 1e-12);
    EXPECT_EQ(share(right, {1, radians(-5.01)}, width), 0);
    EXPECT_EQ(share(right, {1, radians(5.01)}, width), 1);
    EXPECT_NEAR(share(right, {1, radians(2)}, width) + share(right, {1, radians(-2)}, width), 1,
                1e-12);
    EXPECT_NEAR(share(right, {pi / 2, 1}, width), 0.5, 1e-12);
}

TEST(Falloff, HasNoRampAtThePolesNorRoundAWholeTurn) {
    const RootRange all = {{0, pi}, {-pi, pi}};
    EXPECT_EQ(share(all, {0, 0}, 0.2), 1);
    EXPECT_EQ(share(all, {pi, -pi}, 0.2), 1);
    EXPECT_EQ(share(Box{}, {1e9, -1e9, 0}, 0.1), 1);
}

}  // namespace
}  // namespace kushi
