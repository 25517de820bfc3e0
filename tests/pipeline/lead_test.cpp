// SPDX-License-Identifier: Apache-2.0
#include "pipeline/lead.h"

#include <kushi/rods.h>

#include <algorithm>
#include <cmath>
#include <span>
#include <vector>

#include <gtest/gtest.h>

namespace kushi {
namespace {

constexpr std::size_t segments = 40;
constexpr float hairLength = 0.25F;  // m

// A hair that weighs as much as one of 75 micrometres, from a clamp.
Rods hair(Vec3d clamp, float bending) {
    Rods rods;
    rods.roots = {{0, 0, 0}};
    rods.clamps = {frameAlong(clamp)};
    rods.lengths = {hairLength};
    rods.bending = {bending};
    rods.twisting = {4e-9F};
    rods.weights = {5.7e-5F};
    rods.keys = {1};
    rods.offsets = {0, segments};
    return rods;
}

struct Led {
    double wanted = 0, moved = 0;  // of the tip [m]
    double off = 0;                // farthest from where lead() says [m]
};

// By the rods' own solver, which knows nothing of strings.
Led led(Vec3d clamp, float bending, Vec3f sideways) {
    const Rods rods = hair(clamp, bending);
    std::vector<Vec3f> nodes(rods.nodeCount());
    RestState state;
    RodWorld world;
    EXPECT_TRUE(settleRods(rods, world, state, nodes).unsettled.empty());

    std::vector<Vec3f> ways;
    for (std::size_t j = 0; j <= segments; ++j) {
        const auto s = static_cast<float>(j) / segments;
        ways.push_back(s * s * sideways);
    }
    std::vector<Vec3f> loads(segments);
    std::vector<Vec3f> predicted = nodes;
    lead(predicted, ways, std::cbrt(rods.bending[0] / rods.weights[0]), 1, loads);

    const Vec3f tip = nodes.back();
    world.loads = loads;
    RestOptions warm;
    warm.warm = true;
    EXPECT_TRUE(settleRods(rods, world, state, nodes, warm).unsettled.empty());
    Led led;
    led.wanted = double{length(sideways)};
    led.moved = double{length(nodes.back() - tip)};
    for (std::size_t j = 0; j <= segments; ++j)
        led.off = std::max(led.off, double{length(nodes[j] - predicted[j])});
    return led;
}

constexpr float limp = 6.1e-9F;
constexpr float stiff = 1e-7F;

TEST(Lead, BringsHangingHairToWhereItSays) {
    for (const Vec3f sideways : {Vec3f{0, 0, 0.01F}, Vec3f{-0.01F, 0, 0}}) {
        for (const Vec3d clamp : {Vec3d{0, -1, 0}, Vec3d{0.8, -0.6, 0}, Vec3d{1, 0, 0}}) {
            const Led hair = led(clamp, limp, sideways);
            EXPECT_GT(hair.moved, 0.75 * hair.wanted);
            EXPECT_LT(hair.off, 0.15 * hair.wanted);
        }
        const Led hair = led({0, -1, 0}, stiff, sideways);
        EXPECT_GT(hair.moved, 0.5 * hair.wanted);
        EXPECT_LT(hair.off, 0.05 * hair.wanted);
    }
}

TEST(Lead, DoesNotDrawHairAlongItself) {
    const Led hair = led({0, -1, 0}, limp, {0, 0.01F, 0});
    EXPECT_LT(hair.moved, 1e-5);
    EXPECT_LT(hair.off, 1e-5);
}

// A cut may leave two nodes at one place, or one segment.
TEST(Lead, BearsWhatCutsLeave) {
    const auto finite = [](std::span<const Vec3f> all) {
        return std::ranges::all_of(all, [](Vec3f v) { return std::isfinite(length(v)); });
    };
    std::vector<Vec3f> twice = {{0, 0, 0}, {0, -0.01F, 0}, {0, -0.01F, 0}};
    std::vector<Vec3f> one = {{0, 0, 0}, {0, -0.01F, 0}};
    for (std::vector<Vec3f>* nodes : {&twice, &one}) {
        const std::vector<Vec3f> ways(nodes->size(), Vec3f{0.002F, 0, 0});
        std::vector<Vec3f> loads(nodes->size() - 1);
        lead(*nodes, ways, 0.03F, 1, loads);
        EXPECT_TRUE(finite(*nodes));
        EXPECT_TRUE(finite(loads));
        EXPECT_GT(loads[0].x, 0);
    }
}

}  // namespace
}  // namespace kushi
