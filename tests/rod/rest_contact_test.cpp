// SPDX-License-Identifier: Apache-2.0
#include "rod/rest_energy.h"

#include <kushi/ellipsoid.h>

#include <algorithm>

#include <gtest/gtest.h>

namespace kushi {
namespace {

using rest::Settled;
using rest::Strand;

// The ellipsoid of the shipped styles.
const Ellipsoid head = {{0, 0, 0}, {0.105, 0.125, 0.085}, radians(20)};

// Hairs of 5 to 30 cm, as of 75 micrometres, all over the head.
Rods headOfHair(int count, int segments, Vec3d curvature) {
    Rods rods;
    for (int i = 0; i < count; ++i) {
        const std::uint64_t key = mixKey(static_cast<std::uint64_t>(i), 1992);
        const Vec3d root = head.point(
            {radians(110 * uniform(mixKey(key, 1))), radians(180 * uniformSigned(mixKey(key, 2)))});
        rest::addRod(rods, frameAlong(head.normal(root)), 0, segments, key);
        rods.roots.back() = root.as<float>();
        rods.lengths.back() = static_cast<float>(0.05 + 0.25 * uniform(mixKey(key, 3)));
        rods.bending.back() = 6.06e-9F;
        rods.twisting.back() = 4.04e-9F;
        rods.weights.back() = 5.72e-5F;
    }
    if (length(curvature) > 0) rest::curl(rods, curvature);
    return rods;
}

double deepest(const Rods& rods, const Settled& settled) {
    double depth = 0;
    for (std::size_t i = 0; i < rods.size(); ++i) {
        for (std::size_t j = 1; j <= rods.segments(i); ++j)
            depth = std::max(depth, head.depth(settled.nodes[rods.firstNode(i) + j].as<double>()));
    }
    return depth;
}

std::size_t listed(const Settled& settled) {
    return static_cast<std::size_t>(std::count(settled.states.begin(), settled.states.end(), 0));
}

// Which begins between hair beside it, but for few.
TEST(RestContact, HairThatForcesPullRestsAmongOthersWhereItWouldAlone) {
    const Rods rods = headOfHair(4000, 25, {});
    // To both sides, so that some hair may go either way.
    Force forces[2];
    forces[0].direction.vector = {0, 0, 1};
    forces[0].within.z.low = 0;
    forces[1].direction.vector = {0, 0, -1};
    forces[1].within.z.high = 0;
    for (Force& force : forces)
        force.falloff.distance = 0.02;
    const std::vector<float> shares(2 * rods.size(), 1.0F);
    RodWorld world;
    world.obstacle = &head;
    world.forces = forces;
    world.rootShares = shares;
    const Settled together = rest::settle(rods, world);
    EXPECT_LE(listed(together), 1U);

    constexpr std::size_t every = 8;
    std::size_t elsewhere = 0;
    for (std::size_t i = 0; i < rods.size(); i += every) {
        Rods one;
        rest::addRod(one, rods.clamps[i], rods.weights[i], 25, rods.keys[i]);
        one.roots = {rods.roots[i]};
        one.lengths = {rods.lengths[i]};
        one.bending = {rods.bending[i]};
        one.twisting = {rods.twisting[i]};
        const Settled alone = rest::settle(one, world);
        const auto nodes = std::span(together.nodes).subspan(rods.firstNode(i), 26);
        if (rest::gap(one, 0, alone.nodes, nodes) > 1e-4) ++elsewhere;
    }
    EXPECT_LE(elsewhere, rods.size() / every / 100);
}

TEST(RestContact, NoNodeLiesInTheHead) {
    RodWorld world;
    world.obstacle = &head;
    // Straight, and curls of 12 mm radius, which hook onto the head.
    for (const Vec3d curvature : {Vec3d{}, Vec3d{60, 0, 40}}) {
        const Rods rods = headOfHair(10000, 25, curvature);
        const Settled settled = rest::settle(rods, world);
        EXPECT_LE(listed(settled), 1U) << length(curvature);
        EXPECT_LT(deepest(rods, settled), 1e-5);
    }
}

// What hangs free of the head at the end does not lie on it on the way: the lanes, which put all of
// the load on such hair at once, find the rests that the reference finds as the loads grow.
TEST(RestContact, FreeHairEndsWhereGrowingLoadsTakeIt) {
    for (const Vec3d gravity : {Vec3d{0, -1, 0}, Vec3d{0.8, 0.6, 0}, Vec3d{0, 0.6, -0.8}}) {
        Rods rods = headOfHair(3000, 25, {});
        for (std::size_t i = 0; i < rods.size(); ++i) {
            const auto part = [&](std::uint64_t salt) {
                return uniformSigned(mixKey(rods.keys[i], salt));
            };
            const Vec3d normal = head.normal(rods.roots[i].as<double>());
            const Vec3d aslant = normalized(normal + Vec3d{part(5), part(6), part(7)});
            rods.clamps[i] = frameAlong(dot(aslant, normal) > 0.2 ? aslant : normal);
        }
        RodWorld world;
        world.obstacle = &head;
        world.gravity = gravity;
        const Settled lanes = rest::settle(rods, world);
        const Settled exact = rest::settleBy(settleReference, rods, world, 1e-7);
        int others = 0;
        for (std::size_t i = 0; i < rods.size(); ++i) {
            if (lanes.states[i] == 0 || exact.states[i] == 0) continue;
            others += rest::gap(rods, i, lanes.nodes, exact.nodes) > 1e-2 * rods.lengths[i] ? 1 : 0;
        }
        EXPECT_LE(others, 3);
    }
}

// Pulled in from all sides, without a head in the way: to the axis, where the force has no
// direction.
TEST(RestForce, HairThatIsPulledInComesToRest) {
    const Rods rods = headOfHair(300, 25, {});
    const std::vector<float> shares(rods.size(), 1);
    for (const double magnitude : {-0.4, -1.0, -2.0}) {
        Force force;
        force.direction.radial = true;
        force.magnitude = magnitude;
        RodWorld world;
        world.forces = {&force, 1};
        world.rootShares = shares;
        EXPECT_EQ(listed(rest::settle(rods, world)), 0U) << magnitude;
    }
}

// Combed back by a force of one and three times the weight: the front's hair lies on the head.
TEST(RestContact, NorWhenHairIsPressedOnIt) {
    for (const double magnitude : {1.0, 3.0}) {
        Force force;
        force.direction.vector = {-1, 0, 0};
        force.magnitude = magnitude;
        const Rods rods = headOfHair(5000, 25, {});
        const std::vector<float> shares(rods.size(), 1);
        RodWorld world;
        world.obstacle = &head;
        world.forces = {&force, 1};
        world.rootShares = shares;
        const Settled settled = rest::settle(rods, world);
        EXPECT_LT(listed(settled), rods.size() / 1000);
        EXPECT_LT(deepest(rods, settled), 1e-5);
    }
}

// The moments of a strand under its weight and pushes that are not known but in direction: along
// the outward normal at nodes within the skin. Pushes >= 0 that balance them best are sought.
struct Balance {
    double residual = 0;  // over EI/L + w L^2/2
    int touching = 0;
};

std::vector<Vec3d> endsOf(const Strand& strand, std::span<const Vec3d> pushes, double weights) {
    std::vector<Vec3d> ends(strand.size());
    Vec3d beyond;
    for (std::size_t j = strand.size(); j-- > 0;) {
        const Vec3d weight = {0, -weights * strand.weight(j), 0};
        beyond += pushes[j + 1];
        ends[j] = beyond + 0.5 * weight;
        beyond += weight;
    }
    return ends;
}

Balance balance(const Rods& rods, std::size_t index, std::span<const Vec3f> nodes,
                std::span<const float> turns) {
    Strand strand = rest::strandOf(rods, index, turns);
    const double length = rods.lengths[index];
    const double weight = static_cast<double>(rods.weights[index]) * length;
    const double scale = rods.bending[index] / length + 0.5 * weight * length;
    std::vector<Vec3d> pushes(strand.frames.size());
    const std::vector<Vec3d> none = strand.imbalance(pushes);
    std::vector<Vec3d> left = strand.imbalance(endsOf(strand, pushes, 1));

    // Moments of a push of the strand's weight on each touching node.
    std::vector<std::vector<Vec3d>> moments;
    for (std::size_t j = 1; j < strand.frames.size(); ++j) {
        const Vec3d at = nodes[rods.firstNode(index) + j].as<double>();
        const Vec3d normal = head.normal(at);
        // Outside the head by the skin, with some room for its being measured in another way.
        if (head.implicit(at - 1.1 * contactSkin * normal) > 0) continue;
        pushes.assign(pushes.size(), {});
        pushes[j] = weight * normal;
        moments.push_back(strand.imbalance(endsOf(strand, pushes, 0)));
        for (std::size_t k = 0; k < none.size(); ++k)
            moments.back()[k] = moments.back()[k] - none[k];
    }
    // Least squares with pushes >= 0, one after another.
    std::vector<double> share(moments.size());
    for (int sweep = 0; sweep < 20000; ++sweep) {
        double change = 0;
        for (std::size_t p = 0; p < moments.size(); ++p) {
            double square = 0;
            double against = 0;
            for (std::size_t k = 0; k < left.size(); ++k) {
                square += dot(moments[p][k], moments[p][k]);
                against += dot(moments[p][k], left[k]);
            }
            if (square == 0) continue;
            const double step = std::max(-share[p], -against / square);
            share[p] += step;
            change = std::max(change, std::abs(step));
            for (std::size_t k = 0; k < left.size(); ++k)
                left[k] += step * moments[p][k];
        }
        if (change < 1e-9) break;
    }
    Balance result;
    for (const Vec3d& moment : left)
        result.residual = std::max(result.residual, kushi::length(moment) / scale);
    for (const double one : share)
        result.touching += one > 1e-4 ? 1 : 0;
    return result;
}

TEST(RestContact, TheHeadOnlyPushesAndTheMomentsBalance) {
    RodWorld world;
    world.obstacle = &head;
    for (const Vec3d curvature : {Vec3d{}, Vec3d{60, 0, 40}}) {
        const Rods rods = headOfHair(400, 25, curvature);
        const Settled settled = rest::settleBy(settleReference, rods, world, 1e-7);
        int touching = 0;
        double worst = 0;
        for (std::size_t i = 0; i < rods.size(); ++i) {
            if (settled.states[i] == 0) continue;  // listed
            const Balance one = balance(rods, i, settled.nodes, settled.turnsOf(i));
            worst = std::max(worst, one.residual);
            touching += one.touching;
        }
        EXPECT_GT(touching, 60);
        EXPECT_LT(worst, 1e-5);
    }
}

}  // namespace
}  // namespace kushi
