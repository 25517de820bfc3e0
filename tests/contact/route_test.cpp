// SPDX-License-Identifier: Apache-2.0
#include "contact/route.h"

#include <gtest/gtest.h>

namespace kushi {
namespace {

constexpr double pi = std::numbers::pi;
const Ellipsoid sphere = {{0.1, 0, 0}, {1, 1, 1}, 0.3};
const Ellipsoid head = {{0, 0, 0}, {0.105, 0.125, 0.085}, radians(20)};

TEST(Route, IsStraightWhereThatIsFree) {
    const Route route = around(sphere, {1.1, 0, 0}, {3, 1, 0}, 0.1);
    EXPECT_EQ(route.points.size(), 2U);
    EXPECT_NEAR(route.length, std::sqrt(1.9 * 1.9 + 1), 1e-12);
}

TEST(Route, IsATautStringOnASphere) {
    // A quarter along the surface.
    EXPECT_NEAR(around(sphere, {1.1, 0, 0}, {0.1, 0, 1}, 0).length, pi / 2, 1e-3);
    // Twice the tangent from two radii, and the arc between: 180 - 2 * 60 degrees.
    EXPECT_NEAR(around(sphere, {2.1, 0, 0}, {-1.9, 0, 0}, 0).length, 2 * std::sqrt(3) + pi / 3,
                1e-3);
}

TEST(Route, KeepsClearOfTheHead) {
    for (int i = 0; i < 200; ++i) {
        const Vec3d from = head.point({1.6 * std::fmod(0.618 * i, 1.0), 2 * pi * i / 200 - pi});
        const Vec3d to = {-0.12, 0.03, 0.01};
        const Route route = around(head, from, to, 0.004);
        EXPECT_EQ(route.points.front(), from);
        EXPECT_EQ(route.points.back(), to);
        for (std::size_t k = 1; k < route.points.size(); ++k) {
            for (const double t : {0.25, 0.5, 0.75, 1.0}) {
                const Vec3d at = route.points[k - 1] + t * (route.points[k] - route.points[k - 1]);
                // The chord to the first raised point starts on the surface.
                EXPECT_LT(head.depth(at), 1e-4);
            }
        }
        EXPECT_LT(route.length, 0.45);
        EXPECT_NEAR(length(route.directionAt(0.5 * route.length)), 1, 1e-9);
    }
}

TEST(Route, OppositeEndsHaveOne) {
    const Route route = around(sphere, {1.1, 0, 0}, {-0.9, 0, 0}, 0);
    EXPECT_NEAR(route.length, pi, 2e-3);
    for (const Vec3d point : route.points)
        EXPECT_TRUE(isFinite(point));
}

}  // namespace
}  // namespace kushi
