// SPDX-License-Identifier: Apache-2.0
#include "rod/rest_energy.h"

#include <algorithm>
#include <numbers>

#include <gtest/gtest.h>

namespace kushi {
namespace {

struct Held {
    std::vector<Vec3f> nodes;
    RestReport report;
};

Held settleTied(const Rods& rods, std::span<const Tie> ties, const Ellipsoid* obstacle = nullptr) {
    RodWorld world;
    world.ties = ties;
    world.obstacle = obstacle;
    Held held;
    held.nodes.resize(rods.nodeCount());
    RestState state;
    held.report = settleRods(rods, world, state, held.nodes);
    return held;
}

// A level beam whose tip is held at its own height carries 3/8 of its weight there. Where the tie
// is to push and pull along the beam with no force, it must be a little nearer than the beam is
// long: looked for here by the reported force.
TEST(RestTies, AProppedCantileverCarriesThreeEighthsOfItsWeightAtTheProp) {
    const double gamma = 0.1;
    Rods rods;
    rest::addRod(rods, rest::planarClamp(0), gamma, 100);
    double near = 1 - 1e-4;
    double far = 1;
    Vec3f force;
    for (int i = 0; i < 40; ++i) {
        const double x = 0.5 * (near + far);
        const Tie tie = {0, 100, {static_cast<float>(x), 0, 0}};
        const Held held = settleTied(rods, {&tie, 1});
        force = held.report.tieForces[0];
        const bool taut = !held.report.unsettled.empty() || force.x > 0;
        (taut ? far : near) = x;
    }
    EXPECT_NEAR(static_cast<double>(force.y) / gamma, 0.375, 0.375 * 4e-3);
    EXPECT_NEAR(static_cast<double>(force.z) / gamma, 0, 1e-4);
}

// With the reported forces the moments of every node balance, by the energy's own differences.
TEST(RestTies, ForcesBalanceTheMomentsAndHoldTheNodes) {
    for (const auto shape : {rest::Shape::Straight, rest::Shape::Wavy}) {
        const Rods rods = rest::randomHairs(shape, 200, 25);
        std::vector<Tie> ties;
        for (std::uint32_t i = 0; i < rods.size(); ++i) {
            const auto part = [&](std::uint64_t salt) {
                return uniformSigned(mixKey(rods.keys[i], salt));
            };
            const Vec3d point = 0.35 * Vec3d{part(11), part(12), part(13)};
            ties.push_back({i, 20, point.as<float>()});
            if (i % 3 == 0) ties.push_back({i, 25, (0.8 * point).as<float>()});
        }
        RodWorld world;
        world.ties = ties;
        const rest::Settled settled = rest::settleBy(settleReference, rods, world, 1e-7);
        double widest = 0;
        double worst = 0;
        int held = 0;
        for (std::size_t i = 0; i < rods.size(); ++i) {
            if (settled.states[i] == 0) continue;
            ++held;
            rest::Strand strand = rest::strandOf(rods, i, settled.turnsOf(i));
            std::vector<Vec3d> pulls(strand.frames.size());
            for (std::size_t t = 0; t < ties.size(); ++t) {
                if (ties[t].strand != i) continue;
                pulls[ties[t].node] = settled.tieForces[t].as<double>();
                widest = std::max(
                    widest,
                    rest::distance(settled.nodes[rods.firstNode(i) + ties[t].node], ties[t].point));
            }
            std::vector<Vec3d> ends(strand.size());
            Vec3d beyond;
            for (std::size_t j = strand.size(); j-- > 0;) {
                const Vec3d weight = {0, -strand.weight(j), 0};
                beyond += pulls[j + 1];
                ends[j] = beyond + 0.5 * weight;
                beyond += weight;
            }
            const double scale = 1 + 0.5 * static_cast<double>(rods.weights[i]);
            for (const Vec3d& moment : strand.imbalance(ends))
                worst = std::max(worst, length(moment) / scale);
        }
        EXPECT_GT(held, 195);
        EXPECT_LT(widest, 2e-5);
        EXPECT_LT(worst, 2e-5);
    }
}

TEST(RestTies, OutOfReachAreListed) {
    Rods rods;
    for (int i = 0; i < 3; ++i)
        rest::addRod(rods, rest::planarClamp(0.3), 20, 25);
    const Tie ties[] = {{1, 25, {1.5F, 0, 0}}};
    const Held held = settleTied(rods, ties);
    EXPECT_EQ(held.report.unsettled, std::vector<std::uint32_t>{1});
    for (const Vec3f node : held.nodes)
        EXPECT_TRUE(std::isfinite(node.x + node.y + node.z));
}

TEST(RestTies, AWarmSolveKeepsThem) {
    const Rods rods = rest::randomHairs(rest::Shape::Straight, 500, 25);
    std::vector<Tie> ties;
    for (std::uint32_t i = 0; i < rods.size(); ++i)
        ties.push_back({i, 25, {0.3F, -0.4F, 0.2F}});
    RodWorld world;
    world.ties = ties;
    RestState state;
    std::vector<Vec3f> cold(rods.nodeCount());
    std::vector<Vec3f> warm(rods.nodeCount());
    const RestReport first = settleRods(rods, world, state, cold);
    const RestReport second = settleRods(rods, world, state, warm, {1e-5, true, 0});
    EXPECT_LE(first.unsettled.size(), 2U);
    EXPECT_LE(second.unsettled.size(), first.unsettled.size());
    int moved = 0;
    for (std::size_t i = 0; i < rods.size(); ++i)
        moved += rest::gap(rods, i, cold, warm) > 1e-3 ? 1 : 0;
    EXPECT_LE(moved, 2);
}

// Three hairs from different roots in a knot, and two in another.
TEST(RestTies, TheForcesAtAKnotCancel) {
    Rods rods;
    const Vec3f roots[] = {{0, 0, 0}, {0.3F, 0, 0.1F}, {0, 0.05F, -0.3F}, {2, 0, 0}, {2.4F, 0, 0}};
    for (std::uint64_t i = 0; i < 5; ++i) {
        rest::addRod(rods, frameAlong(normalized(Vec3d{0.2, 1, 0.1 * static_cast<double>(i)})),
                     5 + 10 * static_cast<double>(i), 25, i);
        rods.roots.back() = roots[i];
    }
    const Vec3f near = {0.2F, -0.3F, 0};
    const std::vector<Tie> ties = {{0, 20, near, 7},
                                   {1, 25, near, 7},
                                   {2, 18, near, 7},
                                   {3, 25, {2.2F, 0, 0.2F}, 1},
                                   {4, 25, {2.2F, -0.2F, 0.2F}, 1}};
    const Held held = settleTied(rods, ties);
    EXPECT_TRUE(held.report.unsettled.empty());
    const auto place = [&](std::size_t t) {
        return held.nodes[rods.firstNode(ties[t].strand) + ties[t].node];
    };
    const std::vector<std::size_t> knots[] = {{0, 1, 2}, {3, 4}};
    for (const std::vector<std::size_t>& knot : knots) {
        Vec3d sum;
        double size = 0;
        for (const std::size_t t : knot) {
            EXPECT_LT(rest::distance(place(t), place(knot[0])), 3e-5);
            sum += held.report.tieForces[t].as<double>();
            size += length(held.report.tieForces[t].as<double>());
        }
        EXPECT_GT(size, 0.5);
        EXPECT_LT(length(sum), 2e-3 * size);
    }
}

}  // namespace
}  // namespace kushi
