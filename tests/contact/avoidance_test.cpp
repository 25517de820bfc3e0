// SPDX-License-Identifier: Apache-2.0
#include "contact/avoidance.h"

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

}  // namespace
}  // namespace kushi
