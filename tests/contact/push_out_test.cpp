// SPDX-License-Identifier: Apache-2.0
#include "contact/push_out.h"

#include "core/random.h"
#include "rod/analytic_field.h"

#include <cstring>
#include <functional>
#include <limits>
#include <numeric>

#include <gtest/gtest.h>

namespace kushi {
namespace {

constexpr double h = 0.0025;     // m
constexpr double margin = 5e-4;  // m

using Distance = std::function<double(Vec3d)>;

DistanceField fieldOf(const Distance& distance) {
    return rest::sampled({-0.15, -0.15, -0.15}, {0.15, 0.15, 0.15}, h, distance);
}

double toBall(Vec3d at) {
    return rest::sphereDistance(at, {}, 0.06);
}
double toFloor(Vec3d at) {
    return at.y;
}
// Along z, as a neck lies.
double toNeck(Vec3d at) {
    return rest::capsuleDistance(at, {0, 0, -0.3}, {0, 0, 0.3}, 0.04);
}

std::vector<Vec3f> straight(Vec3d from, Vec3d to, int segments) {
    std::vector<Vec3f> nodes;
    for (int i = 0; i <= segments; ++i)
        nodes.push_back((from + (static_cast<double>(i) / segments) * (to - from)).as<float>());
    return nodes;
}

// The least distance of any of `points` places on each segment from `walked` on.
double nearest(const Distance& distance, const std::vector<Vec3f>& nodes, double beyond = 0,
               int points = 64) {
    double least = 1;
    double walked = 0;
    for (std::size_t j = 1; j < nodes.size(); ++j) {
        const Vec3d from = nodes[j - 1].as<double>();
        const Vec3d way = nodes[j].as<double>() - from;
        for (int k = 0; k <= points; ++k) {
            const double share = static_cast<double>(k) / points;
            if (walked + share * length(way) >= beyond)
                least = std::min(least, distance(from + share * way));
        }
        walked += length(way);
    }
    return least;
}

void expectLengths(const std::vector<Vec3f>& before, const std::vector<Vec3f>& after) {
    ASSERT_EQ(before.size(), after.size());
    EXPECT_EQ(before[0], after[0]);
    for (std::size_t j = 1; j < before.size(); ++j) {
        EXPECT_NEAR(length(after[j].as<double>() - after[j - 1].as<double>()),
                    length(before[j].as<double>() - before[j - 1].as<double>()), 5e-8);
    }
}

// What a field's steps leave of a surface [m].
constexpr double fieldError = 5e-5;

TEST(PushOut, TakesAStrandAroundABall) {
    const DistanceField field = fieldOf(toBall);
    for (const double aside : {0.0, 0.01, 0.03, 0.055}) {
        const auto before = straight({-0.1, aside, 0}, {0.1, aside, 0}, 24);
        auto nodes = before;
        ASSERT_LT(nearest(toBall, nodes), -0.004);
        EXPECT_EQ(pushOut(field, margin, nodes), Pushed::Out) << aside;
        expectLengths(before, nodes);
        EXPECT_GT(nearest(toBall, nodes), margin - fieldError) << aside;
    }
}

TEST(PushOut, LaysAStrandOnAFloorThatItWouldGoInto) {
    const DistanceField field = fieldOf(toFloor);
    const auto before = straight({0, 0.03, 0}, {0.02, -0.12, 0}, 20);
    auto nodes = before;
    EXPECT_EQ(pushOut(field, margin, nodes), Pushed::Out);
    expectLengths(before, nodes);
    EXPECT_GT(nearest(toFloor, nodes), margin - 1e-5);
    // No more than is needed: where it has turned it lies low, and runs on the way it leant.
    EXPECT_LT(nodes.back().y, 0.003F);
    EXPECT_GT(nodes.back().x, 0.05F);
}

// What lies beyond the turned segments keeps its direction.
TEST(PushOut, MovesWhatIsBeyondAlong) {
    const DistanceField field = fieldOf(toBall);
    std::vector<Vec3f> nodes = straight({-0.02, 0.065, 0}, {0.06, 0.065, 0}, 16);
    nodes[3].y = 0.05F;  // one node is inside
    const auto before = nodes;
    EXPECT_EQ(pushOut(field, margin, nodes), Pushed::Out);
    expectLengths(before, nodes);
    const Vec3f last = before[16] - before[10];
    EXPECT_LT(length((nodes[16] - nodes[10]) - last), 1e-6F);
}

// From outside down to a neck and through it to the other side: it does not come out there.
// Square on, turning by little leads nowhere: it goes down the wall, or on the way it came along
// it, and not to and fro before it.
TEST(PushOut, GoesAlongAWallThatItRunsStraightInto) {
    const DistanceField wall = fieldOf([](Vec3d at) { return -at.x; });
    std::vector<Vec3f> nodes = straight({-0.035, 0.05, 0.013}, {0.055, 0.05, 0.013}, 9);
    EXPECT_EQ(pushOut(wall, margin, nodes), Pushed::Out);
    for (std::size_t j = 4; j < nodes.size(); ++j) {
        EXPECT_LT(nodes[j].x, 1e-5 - margin);
        EXPECT_LT(nodes[j].y, nodes[j - 1].y - 0.005F) << j;
        EXPECT_NEAR(nodes[j].z, 0.013, 1e-6);
    }
    // Aslant at first: along z on the wall.
    nodes = straight({-0.035, 0.05, -0.05}, {-0.005, 0.05, 0}, 3);
    for (int j = 1; j <= 6; ++j)
        nodes.push_back(nodes[3] + Vec3f{0.01F * static_cast<float>(j), 0, 0});
    EXPECT_EQ(pushOut(wall, margin, nodes), Pushed::Out);
    for (std::size_t j = 5; j < nodes.size(); ++j) {
        EXPECT_GT(nodes[j].z, nodes[j - 1].z + 0.005F) << j;
        EXPECT_NEAR(nodes[j].y, 0.05, 1e-6);
    }
}

TEST(PushOut, StaysOnTheSideThatTheStrandComesFrom) {
    const DistanceField field = fieldOf(toNeck);
    for (const double lean : {-0.02, 0.0, 0.003, 0.03}) {
        // With the tip not past the neck, in it, and far past it.
        for (const double reach : {0.02, 0.0, -0.03, -0.1}) {
            const auto before = straight({-0.01, 0.1, 0}, {lean, reach, 0.002}, 24);
            auto nodes = before;
            EXPECT_NE(pushOut(field, margin, nodes), Pushed::Stuck) << lean << ' ' << reach;
            expectLengths(before, nodes);
            EXPECT_GT(nearest(toNeck, nodes), margin - fieldError) << lean << ' ' << reach;
            // No segment crosses the neck's middle plane but beside the neck.
            for (std::size_t j = 1; j < nodes.size(); ++j) {
                if (nodes[j].y < 0) {
                    EXPECT_GT(std::abs(nodes[j].x), 0.0F);
                    EXPECT_GE(std::abs(nodes[j].x) + 1e-3F,
                              std::sqrt(std::max(0.0F, 0.0016F - nodes[j].y * nodes[j].y)));
                }
            }
        }
    }
}

// A root in a ball, whatever way the strand goes from there: out by a third of the way it goes.
TEST(PushOut, BringsAStrandWithItsRootInsideOutAtASlant) {
    const DistanceField field = fieldOf(toBall);
    for (const double deep : {0.001, 0.005, 0.01}) {
        for (const double angle : {0.0, 60.0, 95.0, 120.0, 175.0}) {
            const Vec3d root = {0, 0.06 - deep, 0};
            const Vec3d way = {std::sin(radians(angle)), std::cos(radians(angle)), 0};
            const auto before = straight(root, root + 0.15 * way, 30);
            auto nodes = before;
            EXPECT_NE(pushOut(field, margin, nodes), Pushed::Stuck) << deep << ' ' << angle;
            expectLengths(before, nodes);
            EXPECT_GT(nearest(toBall, nodes, 3 * (deep + margin) + 3e-4), margin - fieldError)
                << deep << ' ' << angle;
        }
    }
}

TEST(PushOut, LeavesAClearStrandAlone) {
    const DistanceField field = fieldOf(toBall);
    std::vector<Vec3f> nodes;
    for (int i = 0; i <= 40; ++i) {
        const double at = 0.11 * i;
        nodes.push_back(Vec3d{0.0612 * std::cos(at), 0.0612 * std::sin(at), 0.001 * i}.as<float>());
    }
    // Its chords dip by less than what is left over the margin.
    ASSERT_GT(nearest(toBall, nodes), margin + fieldError);
    const auto before = nodes;
    EXPECT_EQ(pushOut(field, margin, nodes), Pushed::No);
    EXPECT_EQ(std::memcmp(before.data(), nodes.data(), nodes.size() * sizeof(Vec3f)), 0);
}

TEST(PushOut, SaysSoInABoxWithoutAWayOut) {
    // Solid but for a hollow of 6 mm: a strand of 10 cm does not fit.
    const DistanceField field = fieldOf([](Vec3d at) { return 0.006 - length(at); });
    const auto before = straight({0, 0, 0}, {0.1, 0, 0}, 4);
    auto nodes = before;
    EXPECT_EQ(pushOut(field, margin, nodes), Pushed::Stuck);
    expectLengths(before, nodes);
}

TEST(PushOut, BearsNodesThatAreNoNumbersOrAtOnePlace) {
    const DistanceField field = fieldOf(toBall);
    const float nan = std::numeric_limits<float>::quiet_NaN();
    for (std::size_t which : {std::size_t{0}, std::size_t{3}, std::size_t{8}}) {
        auto nodes = straight({-0.1, 0, 0}, {0.1, 0, 0}, 8);
        nodes[which] = {nan, 0, 0};
        pushOut(field, margin, nodes);
    }
    auto nodes = straight({-0.1, 0, 0}, {0.1, 0, 0}, 8);
    nodes[4] = nodes[3];
    EXPECT_NE(pushOut(field, margin, nodes), Pushed::Stuck);
    EXPECT_EQ(nodes[4], nodes[3]);
    std::vector<Vec3f> root = {{0, 0, 0}};
    EXPECT_EQ(pushOut(field, margin, root), Pushed::No);
    EXPECT_EQ(root[0], (Vec3f{0, 0, 0}));
}

// Against 256 points a segment.
TEST(PushOut, LeavesAloneWhatDenseSamplingFindsFree) {
    const DistanceField field = fieldOf(toBall);
    constexpr double wide = 0.01;
    int near = 0;
    for (std::uint64_t i = 0; i < 300; ++i) {
        const auto draw = [&](std::uint64_t salt) { return uniformSigned(mixKey(i, salt)); };
        std::vector<Vec3f> nodes = {
            Vec3d{0.1 * draw(1), 0.11 + 0.03 * draw(2), 0.1 * draw(3)}.as<float>()};
        for (std::uint64_t j = 0; j < 12; ++j) {
            const Vec3d way = {draw(4 + 3 * j), draw(5 + 3 * j) - 0.3, draw(6 + 3 * j)};
            nodes.push_back(nodes.back() + (0.012 * way).as<float>());
        }
        const double dense = nearest(
            [&](Vec3d at) { return double{distanceAt(field, at.as<float>())}; }, nodes, 0, 256);
        // All roots are farther off than their way could matter.
        ASSERT_GT(toBall(nodes[0].as<double>()), 0.0195);
        near += dense < wide ? 1 : 0;
        if (std::abs(dense - wide) < 1.2e-4) continue;
        const Pushed how = pushOut(field, wide, nodes);
        EXPECT_EQ(how == Pushed::No, dense > wide) << i;
    }
    EXPECT_GT(near, 20);
}

// However long the segments are that go through it.
TEST(PushOut, MissesNoThinWall) {
    const auto toWall = [](Vec3d at) { return std::abs(at.x) - 0.003; };
    const DistanceField field = fieldOf(toWall);
    for (int segments = 1; segments < 8; ++segments) {
        for (const double aside : {0.0, 0.05, 0.11}) {
            auto nodes = straight({-0.14, -aside, 0}, {0.13, aside, 0.02}, segments);
            EXPECT_NE(pushOut(field, 0, nodes), Pushed::No) << segments;
        }
    }
}

TEST(PushOut, AllowsARootOnASurfaceItsWay) {
    const DistanceField field = fieldOf(toFloor);
    auto leaving = straight({0, 0, 0}, {0.08, 0.06, 0}, 10);
    EXPECT_EQ(pushOut(field, margin, leaving), Pushed::No);
    // One that lies on it has not come out by a third of its way.
    auto lying = straight({0, 0, 0}, {0.1, 0, 0}, 10);
    EXPECT_EQ(pushOut(field, margin, lying), Pushed::Out);
    auto deep = straight({0, -0.003, 0}, {0.08, 0.057, 0}, 10);
    EXPECT_EQ(pushOut(field, margin, deep), Pushed::No);
}

}  // namespace
}  // namespace kushi
