// SPDX-License-Identifier: Apache-2.0
//
// The walk over a whole head: what the ellipsoid does to it.
#include "contact/avoidance.h"

#include <kushi/cantilever.h>

#include <algorithm>
#include <random>

#include <gtest/gtest.h>

namespace kushi {
namespace {

constexpr double pi = std::numbers::pi;

const Ellipsoid head = {{}, {0.105, 0.125, 0.085}, radians(20)};

std::vector<Vec3d> hairAt(EllipsoidAngles at, double length, const CantileverWorld& world,
                          int segments) {
    const Vec3d root = head.point(at);
    const CantileverRod rod = {root, head.normal(root), length, 6.06e-9, 5.72e-5};
    std::vector<Vec3d> nodes(static_cast<std::size_t>(segments) + 1);
    bendCantilever(rod, world, nodes);
    return nodes;
}

CantileverWorld avoiding(Vec3d gravity) {
    CantileverWorld world;
    world.gravity = gravity;
    world.obstacle = &head;
    return world;
}

TEST(CantileverOnAHead, NoNodeOfAHundredThousandRandomStrandsIsInside) {
    std::mt19937_64 random(5);
    std::uniform_real_distribution<double> unit(-1, 1);
    int touched = 0;
    for (int i = 0; i < 100000; ++i) {
        CantileverWorld world = avoiding(2.0 * Vec3d{unit(random), unit(random), unit(random)});
        world.avoidanceSteps = 1 + i % 6;
        const EllipsoidAngles at = {std::acos(unit(random)), pi * unit(random)};
        const double hairLength = 0.02 + 0.38 * std::abs(unit(random));
        const std::vector<Vec3d> nodes = hairAt(at, hairLength, world, 12 + i % 25);
        bool near = false;
        for (const Vec3d& node : nodes) {
            ASSERT_FALSE(isInside({&head, nullptr}, node));
            near = near || (&node != nodes.data() && head.implicit(node) < 0.05);
        }
        touched += near ? 1 : 0;
    }
    EXPECT_GT(touched, 20000);
}

// Settling with twice the segments moves the nodes little: 25 cm of medium hair under gravity.
TEST(CantileverOnAHead, TwentyAndFortySegmentsGiveTheSameHairstyle) {
    std::mt19937_64 random(7);
    std::uniform_real_distribution<double> unit(-1, 1);
    std::vector<double> distances;
    for (int i = 0; i < 4000; ++i) {
        const EllipsoidAngles at = {std::acos((unit(random) + 1) / 2), pi * unit(random)};
        const std::vector<Vec3d> coarse = hairAt(at, 0.25, avoiding({0, -1, 0}), 20);
        const std::vector<Vec3d> fine = hairAt(at, 0.25, avoiding({0, -1, 0}), 40);
        double largest = 0;
        for (std::size_t k = 0; k < coarse.size(); ++k) {
            largest = std::max(largest, length(coarse[k] - fine[2 * k]) / 0.25);
        }
        distances.push_back(largest);
    }
    std::sort(distances.begin(), distances.end());
    EXPECT_LE(distances[distances.size() / 2], 0.01);
    EXPECT_LE(distances[distances.size() * 95 / 100], 0.03);
}

// The paper on its figure 9 (b): hair near the crown stands, for gravity hardly bends what points
// upwards.
TEST(CantileverOnAHead, HairAtTheCrownStandsUnderGravity) {
    const double topTheta =
        std::atan2(std::sin(radians(20)) * 0.105, std::cos(radians(20)) * 0.125);
    const Vec3d top = head.point({topTheta, 0});
    const std::vector<Vec3d> standing = hairAt({topTheta, 0}, 0.25, avoiding({0, -1, 0}), 40);
    EXPECT_GT(standing.back().y - top.y, 0.2);
    const std::vector<Vec3d> fallen = hairAt({pi / 2, pi / 2}, 0.25, avoiding({0, -1, 0}), 40);
    EXPECT_LT(fallen.back().y, fallen.front().y - 0.15);
}

}  // namespace
}  // namespace kushi
