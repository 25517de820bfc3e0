// SPDX-License-Identifier: Apache-2.0
#include "rod/rest_energy.h"

#include <algorithm>

#include <gtest/gtest.h>

namespace kushi {
namespace {

using rest::addRod;
using rest::randomHairs;
using rest::Shape;

constexpr Shape shapes[] = {Shape::Straight, Shape::Wavy, Shape::Curly, Shape::Tight};

// A perturbation of a stable rest costs energy, whatever its direction. The energy is written down
// from its definition in rest_energy.h.
TEST(RestEnergy, IsNeverAboveThatOfPerturbedNeighbours) {
    for (const Shape shape : shapes) {
        const Rods rods = randomHairs(shape, 200, 25);
        const rest::Settled settled = rest::settleBy(settleReference, rods, {}, 1e-9);
        for (std::size_t i = 0; i < rods.size(); ++i) {
            ASSERT_EQ(settled.states[i], 1) << i;
            const rest::Strand strand = rest::strandOf(rods, i, settled.turnsOf(i));
            const double least = strand.energy();
            for (std::uint64_t trial = 0; trial < 20; ++trial) {
                rest::Strand moved = strand;
                // From one node alone to all of them together, by up to 0.01 rad.
                const double size = 0.01 / std::sqrt(3.0) * uniform(mixKey(i, 9 * trial));
                for (std::size_t j = 1; j < moved.frames.size(); ++j) {
                    const std::uint64_t key =
                        mixKey(mixKey(rods.keys[i], trial), trial % 2 == 0 ? 7 : j);
                    moved.frames[j] =
                        moved.frames[j] * rest::turnBy(size * Vec3d{uniformSigned(mixKey(key, 1)),
                                                                    uniformSigned(mixKey(key, 2)),
                                                                    uniformSigned(mixKey(key, 3))});
                }
                // Turns are stored as floats, so a rest is one to 1e-7 squared times the stiffness.
                const double rounding = 1e-10 * (1 + std::abs(least));
                EXPECT_GE(moved.energy(), least - rounding) << static_cast<int>(shape) << ' ' << i;
            }
        }
    }
}

// And the moments of that energy balance.
TEST(RestEnergy, HasNoSlopeAtRest) {
    for (const Shape shape : shapes) {
        const Rods rods = randomHairs(shape, 200, 25);
        const rest::Settled settled = rest::settleBy(settleLanes, rods, {}, 1e-5);
        double largest = 0;
        for (std::size_t i = 0; i < rods.size(); ++i) {
            if (settled.states[i] == 0) continue;
            rest::Strand strand = rest::strandOf(rods, i, settled.turnsOf(i));
            std::vector<Vec3d> ends(strand.size());
            Vec3d beyond;
            for (std::size_t j = strand.size(); j-- > 0;) {
                const Vec3d weight = {0, -strand.weight(j), 0};
                ends[j] = beyond + 0.5 * weight;
                beyond += weight;
            }
            const double scale = 1 + 0.5 * static_cast<double>(rods.weights[i]);
            for (const Vec3d& moment : strand.imbalance(ends))
                largest = std::max(largest, length(moment) / scale);
        }
        // Three components of 1e-5, and the rounding of 25 EI / L times a float's 1e-7 in each.
        EXPECT_LT(largest, 3e-5) << static_cast<int>(shape);
    }
}

TEST(RestRobust, EveryRandomHairSettles) {
    for (const Shape shape : shapes) {
        const Rods rods = randomHairs(shape, 10000, 25);
        RestState state;
        std::vector<Vec3f> nodes(rods.nodeCount());
        const RestReport report = settleRods(rods, {}, state, nodes);
        EXPECT_TRUE(report.unsettled.empty()) << static_cast<int>(shape);
        RecordProperty("refined" + std::to_string(static_cast<int>(shape)),
                       static_cast<int>(report.refined));
        // Doubles are for the few that floats cannot settle.
        EXPECT_LT(report.refined, 300U) << static_cast<int>(shape);
        for (const Vec3f& node : nodes)
            ASSERT_TRUE(isFinite(node));
        for (const float residual : report.residuals)
            EXPECT_LE(residual, 1e-5F);
    }
}

struct Count {
    std::size_t strands = 0, unsettled = 0;
};

// Every node a number, every strand of its length, and each settled or listed.
void expectSane(const Rods& rods, const RodWorld& world, Count& count) {
    RestState state;
    std::vector<Vec3f> nodes(rods.nodeCount());
    for (const bool warm : {false, true}) {
        const RestReport report = settleRods(rods, world, state, nodes, {1e-5, warm, 0});
        std::vector<bool> listed(rods.size());
        for (const std::uint32_t strand : report.unsettled)
            listed[strand] = true;
        for (std::size_t i = 0; i < rods.size(); ++i) {
            EXPECT_TRUE(listed[i] || report.residuals[i] <= 1e-5F) << i;
            double longest = 0;
            for (std::size_t j = 0; j < rods.segments(i); ++j) {
                const std::size_t node = rods.firstNode(i) + j;
                ASSERT_TRUE(isFinite(nodes[node]) && isFinite(nodes[node + 1])) << i;
                longest = std::max(longest, rest::distance(nodes[node], nodes[node + 1]));
            }
            EXPECT_LE(longest, 1.0001 / static_cast<double>(rods.segments(i))) << i;
        }
        count.strands += rods.size();
        count.unsettled += report.unsettled.size();
    }
}

Rods everyWay(bool curly, std::span<const int> counts) {
    Rods rods;
    const Vec3d directions[] = {{1, 0, 0},  {-1, 0, 0},      {0, 1, 0},  {0, -1, 0}, {0, 0, 1},
                                {0, 0, -1}, {1e-6, 1, 1e-6}, {1, -1, 1}, {-1, 2, 3}};
    for (const int segments : counts) {
        for (const Vec3d& direction : directions) {
            for (const double gamma : {1e-3, 1.0, 7.8, 30.0, 1000.0, 3000.0})
                addRod(rods, frameAlong(normalized(direction)), gamma, segments, rods.size());
        }
    }
    if (curly) rest::curl(rods, {6, 1, 3});
    return rods;
}

constexpr int enough[] = {25, 100, 256};
constexpr int few[] = {1, 2, 3};

TEST(RestRobust, AnyDirectionAndLoadSettlesWithEnoughSegments) {
    for (const bool curly : {false, true}) {
        Count count;
        expectSane(everyWay(curly, enough), {}, count);
        EXPECT_EQ(count.unsettled, 0U) << curly;
    }
}

// One to three segments cannot follow an upright strand that falls by half a turn, nor a curl of a
// full one: some have no rest. They are listed.
TEST(RestRobust, WithTooFewSegmentsStrandsSettleOrAreListed) {
    for (const bool curly : {false, true}) {
        Count count;
        expectSane(everyWay(curly, few), {}, count);
        EXPECT_LE(count.unsettled, count.strands / (curly ? 3 : 20)) << curly;
    }
}

TEST(RestRobust, WithoutLoadsAStrandKeepsItsShape) {
    RodWorld world;
    world.gravity = {0, 0, 0};
    for (const bool curly : {false, true}) {
        Count count;
        expectSane(everyWay(curly, enough), world, count);
        EXPECT_EQ(count.unsettled, 0U) << curly;
    }
}

// Hundreds of times its weight, along the strand, against it and across; in a box whose edge the
// strands cross. There need not be a rest of that size of load that Newton's method finds, but
// nothing may go wrong unnoticed.
constexpr int hugeCounts[] = {3, 25};

TEST(RestRobust, HugeForcesSettleOrAreListed) {
    for (const bool curly : {false, true}) {
        const Rods rods = everyWay(curly, hugeCounts);
        const std::vector<float> shares(rods.size(), 1);
        Count count;
        for (const Vec3d& direction : {Vec3d{1, 0, 0}, Vec3d{0, 1, 0}, Vec3d{-0.6, 0, 0.8}}) {
            for (const double magnitude : {30.0, 1000.0}) {
                for (const bool box : {false, true}) {
                    Force force;
                    force.direction.vector = direction;
                    force.magnitude = magnitude;
                    if (box) force.within.x = {0.2, 0.7};
                    RodWorld world;
                    world.forces = {&force, 1};
                    world.rootShares = shares;
                    Count here;
                    expectSane(rods, world, here);
                }
            }
        }
    }
}

}  // namespace
}  // namespace kushi
