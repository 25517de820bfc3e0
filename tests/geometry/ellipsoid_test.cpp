// SPDX-License-Identifier: Apache-2.0
#include <kushi/ellipsoid.h>

#include <algorithm>

#include <gtest/gtest.h>

namespace kushi {
namespace {

constexpr double pi = std::numbers::pi;

Ellipsoid scalp() {
    return {{0.01, -0.02, 0.03}, {0.105, 0.125, 0.085}, radians(20)};
}

void expectNear(Vec3d a, Vec3d b, double tolerance) {
    EXPECT_LE(length(a - b), tolerance)
        << a.x << ' ' << a.y << ' ' << a.z << " against " << b.x << ' ' << b.y << ' ' << b.z;
}

TEST(Ellipsoid, TheWhorlTipsBackwardsForPositiveRotation) {
    const Ellipsoid e = {{}, {0.1, 0.2, 0.3}, radians(20)};
    expectNear(e.point({0, 0}), {-0.2 * std::sin(radians(20)), 0.2 * std::cos(radians(20)), 0},
               1e-15);
    // The front, phi = 0 on the equator, rises with it.
    expectNear(e.point({pi / 2, 0}), {0.1 * std::cos(radians(20)), 0.1 * std::sin(radians(20)), 0},
               1e-15);
    // The person's right is +z.
    expectNear(e.point({pi / 2, pi / 2}), {0, 0, 0.3}, 1e-15);
}

TEST(Ellipsoid, AnglesInvertPoint) {
    const Ellipsoid e = scalp();
    for (double theta = 0.05; theta < pi; theta += 0.3) {
        for (double phi = -pi; phi < pi - 0.01; phi += 0.37) {
            const EllipsoidAngles back = e.angles(e.point({theta, phi}));
            EXPECT_NEAR(back.theta, theta, 1e-12);
            EXPECT_NEAR(std::remainder(back.phi - phi, 2 * pi), 0, 1e-12);
            EXPECT_GE(back.phi, -pi);
            EXPECT_LT(back.phi, pi);
            EXPECT_NEAR(e.implicit(e.point({theta, phi})), 0, 1e-12);
        }
    }
}

TEST(Ellipsoid, ImplicitTellsInsideFromOutside) {
    const Ellipsoid e = scalp();
    const Vec3d p = e.point({1, 2});
    EXPECT_DOUBLE_EQ(e.implicit(e.center), -1);
    EXPECT_NEAR(e.implicit(e.center + 2.0 * (p - e.center)), 3, 1e-12);
}

TEST(Ellipsoid, NormalIsAcrossTheSurfaceAndPointsOut) {
    const Ellipsoid e = scalp();
    const double h = 1e-6;
    for (const EllipsoidAngles at : {EllipsoidAngles{0.4, 1}, {1.6, -2}, {2.8, 3}}) {
        const Vec3d normal = e.normal(e.point(at));
        const Vec3d byTheta = e.point({at.theta + h, at.phi}) - e.point({at.theta - h, at.phi});
        const Vec3d byPhi = e.point({at.theta, at.phi + h}) - e.point({at.theta, at.phi - h});
        EXPECT_NEAR(length(normal), 1, 1e-14);
        EXPECT_NEAR(dot(normal, normalized(byTheta)), 0, 1e-8);
        EXPECT_NEAR(dot(normal, normalized(byPhi)), 0, 1e-8);
        EXPECT_GT(dot(normal, e.point(at) - e.center), 0);
    }
}

TEST(Ellipsoid, DepthOfASphereIsRadiusMinusDistance) {
    const Ellipsoid sphere = {{1, 2, 3}, {0.1, 0.1, 0.1}, 0.5};
    EXPECT_NEAR(sphere.depth({1.03, 2.04, 3}), 0.05, 1e-12);
    EXPECT_NEAR(sphere.depth({1, 2, 3}), 0.1, 1e-12);
    EXPECT_EQ(sphere.depth({1.2, 2, 3}), 0);
}

// The least distance to a fine grid of surface points, refined around the best.
double depthBySearch(const Ellipsoid& e, Vec3d p) {
    EllipsoidAngles best;
    double least = 1e9;
    double window = pi;
    for (int round = 0; round < 12; ++round) {
        const EllipsoidAngles around = best;
        for (int i = -30; i <= 30; ++i) {
            for (int k = -30; k <= 30; ++k) {
                const EllipsoidAngles at = {around.theta + window * i / 30,
                                            around.phi + window * k / 30};
                const double distance = length(e.point(at) - p);
                if (distance < least) {
                    least = distance;
                    best = at;
                }
            }
        }
        window *= 0.2;
    }
    return least;
}

TEST(Ellipsoid, DepthIsTheDistanceToTheNearestSurfacePoint) {
    const Ellipsoid e = scalp();
    for (const Vec3d local : {Vec3d{0.05, 0.03, 0.02},
                              {-0.09, 0.01, 0.003},
                              {0.001, 0.11, 0.01},
                              {0.02, -0.03, 0},
                              {0, 0, 0},
                              {0.03, 0, 0.07}}) {
        const Vec3d p = e.center + e.toWorldDirection(local);
        EXPECT_NEAR(e.depth(p), depthBySearch(e, p), 1e-8);
    }
}

}  // namespace
}  // namespace kushi
