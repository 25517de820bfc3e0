// SPDX-License-Identifier: Apache-2.0
#include <kushi/cantilever.h>

#include <random>

#include <gtest/gtest.h>

namespace kushi {
namespace {

constexpr double pi = std::numbers::pi;

std::vector<Vec3d> bend(const CantileverRod& rod, const CantileverWorld& world, int segments) {
    std::vector<Vec3d> nodes(static_cast<std::size_t>(segments) + 1);
    bendCantilever(rod, world, nodes);
    return nodes;
}

// EI = 0.3, w = 0.7, d = 0.5.
CantileverRod softRod(Vec3d direction, int segments) {
    return {{0, 0, 0}, direction, 0.5 * segments, 0.3, 0.7};
}

void expectNodes(const std::vector<Vec3d>& nodes, const std::vector<Vec3d>& expected,
                 double tolerance) {
    ASSERT_EQ(nodes.size(), expected.size());
    for (std::size_t i = 0; i < nodes.size(); ++i) {
        EXPECT_LT(length(nodes[i] - expected[i]), tolerance)
            << "node " << i << ": " << nodes[i].x << ' ' << nodes[i].y << ' ' << nodes[i].z;
    }
}

// By hand: y = (0.7 * 0.25 * 1/2) * 0.25 / 0.6 and p1 = 0.5 (0.5, -y) / |(0.5, -y)|; with two
// segments y / d = 7 / 24, and 7, 24, 25 is a Pythagorean triple. The longer walks were computed in
// 40-digit decimals from e = d a0 + d^2 / (2 EI) (M - (M . a0) a0), which needs no axes a1 and a2.
TEST(Cantilever, LevelRodsAgreeWithTheHandCalculation) {
    expectNodes(bend(softRod({1, 0, 0}, 1), {}, 1),
                {{0, 0, 0}, {0.4986760669530411, -0.03636179654865924, 0}}, 1e-15);
    expectNodes(bend(softRod({1, 0, 0}, 2), {}, 2),
                {{0, 0, 0}, {0.48, -0.14, 0}, {0.9490522263499929, -0.3131762366957864, 0}}, 1e-15);
    expectNodes(bend(softRod({1, 0, 0}, 3), {}, 3),
                {{0, 0, 0},
                 {0.4180239554185313, -0.2743282207434112, 0},
                 {0.7591579854728973, -0.6398792753703497, 0},
                 {1.081707423433802, -1.021928827223384, 0}},
                1e-15);
}

TEST(Cantilever, ASlantedRodAgreesWithTheHandCalculation) {
    expectNodes(bend(softRod({0.6, 0.8, 0}, 3), {}, 3),
                {{0, 0, 0},
                 {0.425689327837917, 0.2622758017143451, 0},
                 {0.9020399222589339, 0.4142301079868025, 0},
                 {1.387775831868158, 0.5328076189916288, 0}},
                1e-15);
}

TEST(Cantilever, AnUprightRodStandsUnderGravityAndLeansUnderASideLoad) {
    expectNodes(bend(softRod({0, 1, 0}, 3), {}, 3),
                {{0, 0, 0}, {0, 0.5, 0}, {0, 1, 0}, {0, 1.5, 0}}, 1e-15);
    CantileverWorld world;
    world.gravity = {0.3, -1, 0.2};
    expectNodes(bend(softRod({0, 1, 0}, 3), world, 3),
                {{0, 0, 0},
                 {0.09579248237739575, 0.4865649898534387, 0.06386165491826383},
                 {0.2578922244256204, 0.9470487641076568, 0.1719281496170803},
                 {0.4399027317723834, 1.396658258595171, 0.2932684878482556}},
                1e-15);
}

TEST(Cantilever, ASkewRodUnderASkewLoadAgreesWithTheHandCalculation) {
    CantileverWorld world;
    world.gravity = {0.2, -1, -0.5};
    expectNodes(bend(softRod({2.0 / 3, 1.0 / 3, 2.0 / 3}, 3), world, 3),
                {{0, 0, 0},
                 {0.4307271901062684, -0.08614543802125367, 0.238857805422567},
                 {0.8548639169183815, -0.3039274658323088, 0.3894533741874273},
                 {1.271035527257893, -0.5502400977844103, 0.5164623427221203}},
                1e-15);
}

TEST(Cantilever, ATipLoadHasItsOwnArm) {
    CantileverWorld world;
    world.gravity = {};
    world.tipLoad = {0, -0.25, 0.1};
    expectNodes(bend(softRod({1, 0, 0}, 2), world, 2),
                {{0, 0, 0},
                 {0.4930668410890925, -0.07704169392017071, 0.03081667756806828},
                 {0.9807979536600907, -0.1792515938651991, 0.07170063754607962}},
                1e-15);
}

// A beam under its own weight drops by w L^4 / (8 EI); the walk along chords by half of that.
TEST(Cantilever, SmallDeflectionTendsToHalfOfTheBeams) {
    const CantileverRod rod = {{0, 0, 0}, {1, 0, 0}, 0.2, 1, 1e-3};
    const double drop = 1e-3 * std::pow(0.2, 4) / 16;
    const auto dropWith = [&](int n) { return -bend(rod, {}, n).back().y / drop; };
    EXPECT_NEAR((dropWith(100) - 1) / (dropWith(200) - 1), 2, 0.05);  // first order in 1/n
    EXPECT_NEAR(2 * dropWith(400) - dropWith(200), 1, 1e-4);
}

// A tip load P drops a beam's tip by P L^3 / (3 EI).
TEST(Cantilever, ASmallTipLoadTendsToHalfOfTheBeamsToo) {
    CantileverWorld world;
    world.gravity = {};
    world.tipLoad = {0, -1e-5, 0};
    const CantileverRod rod = {{0, 0, 0}, {1, 0, 0}, 0.2, 1, 1e-3};
    EXPECT_NEAR(-bend(rod, world, 400).back().y / (1e-5 * std::pow(0.2, 3) / 6), 1, 0.005);
}

TEST(Cantilever, ARigidRodStaysStraight) {
    const Vec3d direction = normalized(Vec3d{1, 2, -3});
    const CantileverRod rod = {{1, 2, 3}, direction, 0.25, 1e6, 5e-5};
    EXPECT_LT(length(bend(rod, {}, 24).back() - (rod.root + 0.25 * direction)), 1e-12);
}

CantileverRod randomRod(std::mt19937_64& random) {
    std::uniform_real_distribution<double> unit(-1, 1);
    const Vec3d direction = normalized(Vec3d{unit(random), unit(random), unit(random)});
    return {{unit(random), unit(random), unit(random)},
            direction,
            0.05 + 0.25 * std::abs(unit(random)),
            6e-9 * std::exp(2 * unit(random)),
            5.7e-5};
}

TEST(Cantilever, LengthIsKept) {
    std::mt19937_64 random(1);
    for (int i = 0; i < 1000; ++i) {
        const CantileverRod rod = randomRod(random);
        const std::vector<Vec3d> nodes = bend(rod, {}, 24);
        for (std::size_t k = 1; k < nodes.size(); ++k) {
            ASSERT_NEAR(length(nodes[k] - nodes[k - 1]) * 24 / rod.length, 1, 1e-12);
        }
    }
}

TEST(Cantilever, TheMirrorImageOfTheRodBendsToTheMirrorImage) {
    std::mt19937_64 random(2);
    CantileverWorld world;
    world.gravity = {0.3, -1, 0.2};
    CantileverWorld mirrored = world;
    mirrored.gravity.z = -world.gravity.z;
    for (int i = 0; i < 200; ++i) {
        CantileverRod rod = randomRod(random);
        const std::vector<Vec3d> nodes = bend(rod, world, 24);
        rod.root.z = -rod.root.z;
        rod.direction.z = -rod.direction.z;
        const std::vector<Vec3d> image = bend(rod, mirrored, 24);
        for (std::size_t k = 0; k < nodes.size(); ++k) {
            ASSERT_LT(length(image[k] - Vec3d{nodes[k].x, nodes[k].y, -nodes[k].z}), 1e-12);
        }
    }
}

TEST(Cantilever, TurnsWithTheRodAboutTheVertical) {
    std::mt19937_64 random(3);
    const auto turn = [](Vec3d v) {
        return Vec3d{std::cos(1.1) * v.x + std::sin(1.1) * v.z, v.y,
                     std::cos(1.1) * v.z - std::sin(1.1) * v.x};
    };
    for (int i = 0; i < 200; ++i) {
        CantileverRod rod = randomRod(random);
        const std::vector<Vec3d> nodes = bend(rod, {}, 24);
        rod.root = turn(rod.root);
        rod.direction = turn(rod.direction);
        const std::vector<Vec3d> turned = bend(rod, {}, 24);
        for (std::size_t k = 0; k < nodes.size(); ++k) {
            // Soft, nearly upright rods amplify rounding.
            ASSERT_LT(length(turned[k] - turn(nodes[k])), 1e-7);
        }
    }
}

TEST(Cantilever, HangingHairStaysAsItHangs) {
    const CantileverRod rod = {{0, 0, 0}, {0, -1, 0}, 0.3, 6e-9, 5.7e-5};
    EXPECT_LT(length(bend(rod, {}, 24).back() - Vec3d{0, -0.3, 0}), 1e-14);
}

}  // namespace
}  // namespace kushi
