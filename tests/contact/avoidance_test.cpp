// SPDX-License-Identifier: Apache-2.0
#include "contact/avoidance.h"

#include "rod/analytic_field.h"

#include <random>

#include <gtest/gtest.h>

namespace kushi {
namespace {

constexpr double pi = std::numbers::pi;

Vec3d turned(Vec3d along, Vec3d aside, double angle) {
    return std::cos(radians(angle)) * along + std::sin(radians(angle)) * aside;
}

// The paper's figure 6: a segment that comes down on the ellipsoid from the side. n1+ and n1- are
// outside, n2+ too, n2- inside; then only the plus side goes on, n3+ and n4+, and n4+ is taken.
TEST(Avoidance, GoesThroughTheStepsOfTheFigure) {
    const Ellipsoid circle = {{}, {1, 1, 1}, 0};
    // From this point segments of length 0.32 end inside within 45 degrees of straight down; this
    // one comes down at 40.
    const Vec3d from = {0, 1.2, 0};
    const Vec3d along = 0.32 * Vec3d{std::sin(radians(40)), -std::cos(radians(40)), 0};
    const Vec3d aside = 0.32 * Vec3d{std::cos(radians(40)), std::sin(radians(40)), 0};
    const Vec3d before = from - Vec3d{0.3, -0.06, 0};
    ASSERT_GT(dot(aside, from - before), 0);

    const auto inside = [&](double angle) {
        return isInside({&circle, nullptr}, from + turned(along, aside, angle));
    };
    ASSERT_TRUE(inside(0));
    ASSERT_FALSE(inside(90));     // n1+
    ASSERT_FALSE(inside(-90));    // n1-
    ASSERT_FALSE(inside(45));     // n2+
    ASSERT_TRUE(inside(-45));     // n2-
    ASSERT_FALSE(inside(22.5));   // n3+
    ASSERT_FALSE(inside(11.25));  // n4+

    const Vec3d expected = from + turned(along, aside, 11.25);
    EXPECT_LT(length(avoid({&circle, nullptr}, before, from, from + along, 4) - expected), 1e-14);
    // With fewer steps it stops at the angle reached.
    EXPECT_LT(length(avoid({&circle, nullptr}, before, from, from + along, 2) -
                     (from + turned(along, aside, 45))),
              1e-14);
}

TEST(Avoidance, TakesTheSideNearerToTheHairWhereBothLastAsLong) {
    const Ellipsoid sphere = {{}, {1, 1, 1}, 0};
    const Vec3d from = {0, 1, 0};
    const Vec3d to = from + Vec3d{0, -0.2, 0};  // straight in: both sides alike
    const Vec3d right = avoid({&sphere, nullptr}, from + Vec3d{-0.1, 0.1, 0}, from, to, 4);
    EXPECT_GT(right.x, 0);
    const Vec3d left = avoid({&sphere, nullptr}, from + Vec3d{0.1, 0.1, 0}, from, to, 4);
    EXPECT_LT(left.x, 0);
}

TEST(Avoidance, InLineTurnsInThePlaneOfTheOutwardNormal) {
    const Ellipsoid sphere = {{}, {1, 1, 1}, 0};
    const Vec3d from = {0, 1, 0};
    const Vec3d along = 0.3 * normalized(Vec3d{1, -1, 0});
    const Vec3d to = avoid({&sphere, nullptr}, from - along, from, from + along, 4);
    EXPECT_NEAR(to.z, 0, 1e-15);
    // 90 and 45 clear the sphere, 22.5 does not: from the tangent upwards by 45 - 45 = 0 degrees.
    EXPECT_LT(length(to - (from + Vec3d{0.3, 0, 0})), 1e-12);
}

TEST(Avoidance, NeverEndsInsideAndKeepsTheLength) {
    const Ellipsoid e = {{0.01, 0, 0}, {0.105, 0.125, 0.085}, radians(20)};
    std::mt19937_64 random(6);
    std::uniform_real_distribution<double> unit(-1, 1);
    int avoided = 0;
    for (int i = 0; i < 200000; ++i) {
        const Vec3d surface = e.point({std::acos(unit(random)), pi * unit(random)});
        const Vec3d from = surface + 0.005 * std::abs(unit(random)) * e.normal(surface);
        const Vec3d before =
            from + 0.01 * normalized(Vec3d{unit(random), unit(random), unit(random)});
        const double d = 0.001 + 0.03 * std::abs(unit(random));
        const Vec3d to = from + d * normalized(Vec3d{unit(random), unit(random), unit(random)});
        if (!isInside({&e, nullptr}, to)) continue;
        ++avoided;
        const Vec3d out = avoid({&e, nullptr}, before, from, to, 1 + i % 8);
        ASSERT_FALSE(isInside({&e, nullptr}, out));
        ASSERT_NEAR(length(out - from), d, 1e-12 * d + 1e-15);
    }
    EXPECT_GT(avoided, 10000);
}

// Solids with samples a millimetre apart: no angle is near enough to a limit for that to matter.
DistanceField solidOf(double (*distance)(Vec3d)) {
    return rest::sampled({-0.05, -0.05, -0.05}, {0.05, 0.05, 0.05}, 0.001, distance);
}

TEST(Avoidance, TurnsASegmentFromAFloorByTheSameSteps) {
    const DistanceField ground = solidOf([](Vec3d at) { return at.y; });
    const Obstacles obstacles = {nullptr, &ground};
    const Vec3d from = {0, 0.001, 0};
    const Vec3d along = turned({0.01, 0, 0}, {0, -0.01, 0}, 40);
    ASSERT_TRUE(isInside(obstacles, from + along));
    // In line with the one before: towards the outward normal by 90 and 45 degrees; 22.5 are not
    // enough.
    const Vec3d line = avoid(obstacles, from - along, from, from + along, 4);
    EXPECT_LT(length(line - (from + turned({0.01, 0, 0}, {0, 0.01, 0}, 5))), 1e-6);
    // Else towards the one before, here along the floor and a little up.
    const Vec3d before = from - Vec3d{0.003, -0.002, 0.009};
    const Vec3d aside =
        0.01 * normalized((from - before) - dot(from - before, along) / dot(along, along) * along);
    const Vec3d out = avoid(obstacles, before, from, from + along, 8);
    EXPECT_FALSE(isInside(obstacles, out));
    EXPECT_NEAR(length(out - from), 0.01, 1e-9);
    // It is turned about an axis across both, and half of the angle would not do.
    const double angle = std::acos(dot(out - from, along) / dot(along, along));
    EXPECT_NEAR(dot(out - from, cross(along, aside)), 0, 1e-12);
    EXPECT_TRUE(isInside(obstacles,
                         from + std::cos(angle / 2) * along +
                             std::sin(angle / 2) * (dot(out - from, aside) > 0 ? aside : -aside)));
}

// In a slot that is open above: both sides of a segment that comes straight down are inside.
TEST(Avoidance, TurnsAlongTheNormalWhereNeitherSideIsFree) {
    const DistanceField slot =
        solidOf([](Vec3d at) { return std::min(at.y, 0.004 - std::abs(at.x)); });
    const Obstacles obstacles = {nullptr, &slot};
    const Vec3d from = {0, 0.002, 0};
    // Aslant, so that back is not up.
    const Vec3d along = {0.004, -0.0092, 0};
    const Vec3d before = from + Vec3d{0.0004, 0.01, 0};
    ASSERT_TRUE(isInside(obstacles, from + along));
    const Vec3d out = avoid(obstacles, before, from, from + along, 4);
    EXPECT_LT(length(out - (from + Vec3d{0, length(along), 0})), 1e-4);
    EXPECT_FALSE(isInside(obstacles, out));
}

TEST(Avoidance, KeepsOutOfEllipsoidAndSolidsTogether) {
    const Ellipsoid ball = {{-0.02, -0.01, 0}, {0.02, 0.02, 0.02}, 0};
    const DistanceField ground = solidOf([](Vec3d at) { return at.y; });
    const Obstacles obstacles = {&ball, &ground};
    std::mt19937_64 random(8);
    std::uniform_real_distribution<double> unit(-1, 1);
    int avoided = 0;
    for (int i = 0; i < 20000; ++i) {
        const Vec3d from = {0.01 * unit(random), 0.011 + 0.01 * unit(random), 0.01 * unit(random)};
        if (isInside(obstacles, from)) continue;
        const Vec3d before =
            from + 0.01 * normalized(Vec3d{unit(random), unit(random), unit(random)});
        const Vec3d to = from + 0.012 * normalized(Vec3d{unit(random), unit(random), unit(random)});
        if (!isInside(obstacles, to)) continue;
        ++avoided;
        const Vec3d out = avoid(obstacles, before, from, to, 1 + i % 8);
        EXPECT_FALSE(isInside(obstacles, out));
        EXPECT_NEAR(length(out - from), 0.012, 1e-12);
    }
    EXPECT_GT(avoided, 3000);
}

TEST(IsInside, OfNothingIsNothing) {
    EXPECT_FALSE(isInside({}, {0, 0, 0}));
    const DistanceField ground = solidOf([](Vec3d at) { return at.y; });
    EXPECT_TRUE(isInside({nullptr, &ground}, {0, -1e-4, 0}));
    EXPECT_FALSE(isInside({nullptr, &ground}, {0, 1e-4, 0}));
}

}  // namespace
}  // namespace kushi
