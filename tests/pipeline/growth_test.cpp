// SPDX-License-Identifier: Apache-2.0
#include "pipeline/growth.h"

#include <kushi/head.h>
#include <kushi/settle.h>

#include <algorithm>
#include <cmath>
#include <functional>

#include <gtest/gtest.h>

namespace kushi {
namespace {

Part leaning(double lift) {
    Part part;
    part.name = "hair";
    part.scalp.ellipsoid = headEllipsoid();
    part.scalp.spacing = 0.006;
    part.scalp.regions = {{{0, radians(100)}, {}}};
    part.hair.length = 0.01;
    part.hair.lift = radians(lift);
    return part;
}

RootPlace placeAt(const Part& part, double theta, double phi) {
    const EllipsoidAngles at = {radians(theta), radians(phi)};
    const Vec3d point = part.scalp.ellipsoid.point(at);
    return {point, part.scalp.ellipsoid.normal(point), at};
}

double angleBetween(Vec3d a, Vec3d b) {
    return degrees(std::atan2(length(cross(a, b)), dot(a, b)));
}

TEST(GrowthDirection, IsUprightUnlessItLeans) {
    Part part = leaning(90);
    const RootPlace root = placeAt(part, 50, 40);
    EXPECT_EQ(growthDirection(part, root), root.normal);
    part.hair.growth = Growth::Radial;
    EXPECT_EQ(growthDirection(part, root), normalized(root.point));
}

TEST(GrowthDirection, LeansByItsLiftTowardsWhatItIsTold) {
    for (const double lift : {0.0, 20.0, 55.0, 89.0}) {
        for (const Vec3d towards : {Vec3d{0, -1, 0}, Vec3d{-1, 0, 0}, Vec3d{0.6, 0, 0.8}}) {
            Part part = leaning(lift);
            part.hair.lean.direction.vector = towards;
            const RootPlace root = placeAt(part, 50, 40);
            const Vec3d direction = growthDirection(part, root);
            EXPECT_NEAR(length(direction), 1, 1e-12);
            EXPECT_NEAR(angleBetween(direction, root.normal), 90 - lift, 1e-9);
            // In the plane of the normal and the aim, on the aim's side.
            EXPECT_NEAR(dot(direction, normalized(cross(root.normal, towards))), 0, 1e-12);
            const Vec3d aside = towards - dot(towards, root.normal) * root.normal;
            EXPECT_GE(dot(direction, aside), 0);
        }
    }
}

TEST(GrowthDirection, LeansInAndOutFromTheAxis) {
    Part part = leaning(30);
    part.hair.lean.direction = {true, {}};
    const RootPlace root = placeAt(part, 30, 40);
    const Vec3d out = {root.point.x, 0, root.point.z};
    EXPECT_GT(dot(growthDirection(part, root), out), dot(root.normal, out));
    part.hair.lean.reversed = true;
    EXPECT_LT(dot(growthDirection(part, root), out), dot(root.normal, out));
}

TEST(GrowthDirection, IsUprightWhereNothingAimsAcross) {
    Part part = leaning(10);
    const RootPlace root = placeAt(part, 60, 0);
    part.hair.lean.direction.vector = -root.normal;
    EXPECT_EQ(growthDirection(part, root), root.normal);
    part.hair.lean.whorl = Whorl{{radians(60), 0}, 0};
    EXPECT_EQ(growthDirection(part, root), root.normal);
}

// Seen from above the whorl at the top, of a ball: x to the front, z to the right, so that
// counter-clockwise is from front to left.
TEST(GrowthDirection, RunsAwayFromAWhorlAndAroundIt) {
    Part part = leaning(0);
    part.scalp.ellipsoid = {{0.01, 0.02, 0.03}, {0.1, 0.1, 0.1}, 0};
    for (const double turn : {0.0, 40.0, -90.0}) {
        part.hair.lean.whorl = Whorl{{0, 0}, radians(turn)};
        for (const double phi : {0.0, 90.0, -135.0}) {
            const RootPlace root = placeAt(part, 25, phi);
            const Vec3d away = {std::cos(radians(25)) * std::cos(radians(phi)),
                                -std::sin(radians(25)),
                                std::cos(radians(25)) * std::sin(radians(phi))};
            const Vec3d left = {std::sin(radians(phi)), 0, -std::cos(radians(phi))};
            const Vec3d expected = std::cos(radians(turn)) * away + std::sin(radians(turn)) * left;
            EXPECT_LT(length(growthDirection(part, root) - expected), 1e-9) << turn << ' ' << phi;
        }
    }
}

// First segments of a whole style, measured from the normals of a surface.
void expectLift(const Part& part, Method method, const std::function<Vec3d(Vec3d)>& normalAt,
                double tolerance) {
    Style style;
    style.solver.method = method;
    style.solver.segments = 5;
    style.gravity = {0, 0, 0};
    style.headCollides = false;
    style.contact.layers = false;
    style.parts = {part};
    const Result<SettledGroom> groom = settle(style);
    ASSERT_TRUE(groom.ok()) << toString(groom.problems()[0]);
    ASSERT_GT(groom->strands.size(), 500U);
    int leaning = 0;
    for (std::size_t i = 0; i < groom->strands.size(); ++i) {
        const auto nodes = groom->strands.strand(i);
        const Vec3d root = nodes[0].as<double>();
        const Vec3d normal = normalAt(root);
        if (std::abs(normal.y) > 0.98) continue;
        const Vec3d first = normalized((nodes[1] - nodes[0]).as<double>());
        EXPECT_NEAR(angleBetween(first, normal), 90 - degrees(part.hair.lift), tolerance);
        EXPECT_LT(first.y, normal.y);
        ++leaning;
    }
    EXPECT_GT(leaning, 400);
}

TEST(GrowthDirection, IsThatOfTheStrandsByEitherMethod) {
    const Part part = leaning(35);
    const auto normalAt = [&](Vec3d root) { return part.scalp.ellipsoid.normal(root); };
    expectLift(part, Method::Cantilever, normalAt, 0.2);
    expectLift(part, Method::Equilibrium, normalAt, 0.2);
}

// Against the triangle of the mannequin that is nearest, which is flat.
TEST(GrowthDirection, IsMeasuredFromTheHeadThatHairGrowsFrom) {
    const Mesh head = mannequin();
    Part part = leaning(35);
    part.scalp.surface = ScalpSurface::Head;
    const auto normalAt = [&](Vec3d root) {
        double least = 1;
        Vec3d normal;
        for (std::size_t i = 0; i < head.vertices.size(); ++i) {
            const double distance = length(head.vertices[i].as<double>() - root);
            if (distance < least) normal = head.normals[i].as<double>();
            least = std::min(least, distance);
        }
        return normal;
    };
    part.scalp.regions = {{{0, radians(55)}, {}}};
    expectLift(part, Method::Cantilever, normalAt, 4);
    expectLift(part, Method::Equilibrium, normalAt, 4);
}

}  // namespace
}  // namespace kushi
