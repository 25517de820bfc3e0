// SPDX-License-Identifier: Apache-2.0
//
// The lanes of floats against the double reference, on every instruction set of this processor.
#include "every_target.h"
#include "rod/kernel/batch-inl.h"
#include "rod/rest_rods.h"

#include <algorithm>
#include <cstring>
#include <numeric>

namespace kushi {
namespace {

namespace kernel = HWY_NAMESPACE;
using rest::randomHairs;
using rest::settleBy;
using rest::Shape;

constexpr Shape shapes[] = {Shape::Straight, Shape::Wavy, Shape::Curly, Shape::Tight};

using RestLanes = OnEveryTarget;

// Sanitizers make them some hundred times as slow.
#if defined(__SANITIZE_ADDRESS__)
constexpr int hairs = 150;
#else
constexpr int hairs = 1000;
#endif

// The rods, to begin where others have ended.
Rods startedAt(const Rods& rods, const rest::Settled& settled) {
    Rods started = rods;
    for (std::size_t i = 0; i < rods.size(); ++i) {
        const std::span<const float> turns = settled.turnsOf(i);
        for (std::size_t j = 0; j < rods.segments(i); ++j) {
            if (rods.naturalCurvature.empty()) {
                started.starts.push_back(
                    frameAlong({turns[3 * j], turns[3 * j + 1], turns[3 * j + 2]}));
            } else {
                started.starts.push_back(
                    {turns[4 * j], turns[4 * j + 1], turns[4 * j + 2], turns[4 * j + 3]});
            }
        }
    }
    return started;
}

// The reference begins where the lanes ended, as a heavy curl has many rests.
TEST_F(RestLanes, AgreeWithTheReferenceOnEveryTarget) {
    const std::vector<std::int64_t> targets = targetsHere();
    ASSERT_FALSE(targets.empty());
    for (const Shape shape : shapes) {
        const Rods rods = randomHairs(shape, hairs, 25);
        for (const std::int64_t target : targets) {
            use(target);
            const rest::Settled lanes = settleBy(settleLanes, rods, {}, 1e-5);
            const rest::Settled exact = settleBy(settleReference, startedAt(rods, lanes), {}, 1e-8);
            int settled = 0;
            std::vector<double> gaps;
            for (std::size_t i = 0; i < rods.size(); ++i) {
                if (lanes.states[i] == 0) continue;
                ++settled;
                gaps.push_back(rest::gap(rods, i, exact.nodes, lanes.nodes));
            }
            std::sort(gaps.begin(), gaps.end());
            RecordProperty(
                "gaps" + std::to_string(static_cast<int>(shape)) + "_" + hwy::TargetName(target),
                std::to_string(1e6 * gaps[gaps.size() / 2]) + " " +
                    std::to_string(1e6 * gaps[gaps.size() * 99 / 100]) + " " +
                    std::to_string(1e6 * gaps.back()));
            // The rest is for the reference.
            EXPECT_GE(settled, hairs * 98 / 100) << hwy::TargetName(target);
            // A residual of 1e-5 moves a strand by so much times its compliance: little in the
            // middle, more where a heavy curl is about to turn over.
            EXPECT_LT(gaps[gaps.size() / 2], 2e-5) << hwy::TargetName(target);
            EXPECT_LT(gaps[gaps.size() * 99 / 100], 1e-3) << hwy::TargetName(target);
            EXPECT_LT(gaps.back(), 2e-3) << hwy::TargetName(target);
        }
    }
}

// From the unloaded shape with loads that grow by a twentieth at a time, in double precision.
template <class Element>
std::vector<Vec3f> followed(const Rods& rods) {
    using kernel::Block;
    std::vector<Vec3f> nodes(rods.nodeCount());
    std::vector<float> residuals(rods.size());
    std::vector<std::uint8_t> states(rods.size());
    std::vector<std::uint32_t> strands(rods.size());
    std::iota(strands.begin(), strands.end(), 0U);
    const RodWorld world;
    StrandBatch batch;
    batch.rods = &rods;
    batch.world = &world;
    batch.strands = strands;
    batch.nodes = nodes;
    batch.residuals = residuals;
    batch.states = states;
    kernel::NewtonOptions options;
    options.tolerance = 1e-6;
    options.growth = 1.05;
    options.readiness = 1e-4;
    options.reach = 0.2;
    options.maxSteps = 4000;
    Block<double, Element> block(batch);
    for (const std::uint32_t strand : strands) {
        block.take({&strand, 1});
        block.unbend();
        kernel::nudge(block);
        kernel::Progress<double> at{};
        at.share = std::min(1.0, 0.1 / block.gamma());
        kernel::settleBlock(block, options, at);
        block.write(at, true);
    }
    return nodes;
}

// Measured 0, 0, 1 and 2 of 1000.
TEST(RestBranch, IsTheOneThatGrowingLoadsLeadTo) {
    const int most[] = {0, 1, 4, 6};
    for (const Shape shape : shapes) {
        const Rods rods = randomHairs(shape, hairs, 25);
        const std::vector<Vec3f> fine = shape == Shape::Straight
                                            ? followed<kernel::Straight<double>>(rods)
                                            : followed<kernel::Curly<double>>(rods);
        std::vector<Vec3f> nodes(rods.nodeCount());
        RestState state;
        settleRods(rods, {}, state, nodes);
        int others = 0;
        for (std::size_t i = 0; i < rods.size(); ++i)
            others += rest::gap(rods, i, fine, nodes) > 1e-2 ? 1 : 0;
        RecordProperty("others" + std::to_string(static_cast<int>(shape)), others);
        EXPECT_LE(others, most[static_cast<std::size_t>(shape)]) << static_cast<int>(shape);
    }
}

std::vector<Vec3f> nodesWith(const Rods& rods, int threads) {
    std::vector<Vec3f> nodes(rods.nodeCount());
    RestState state;
    settleRods(rods, {}, state, nodes, {1e-5, false, threads});
    return nodes;
}

TEST(RestThreads, GiveTheSameBytes) {
    for (const Shape shape : {Shape::Straight, Shape::Curly}) {
        const Rods rods = randomHairs(shape, 3000, 25);
        const std::vector<Vec3f> one = nodesWith(rods, 1);
        for (const int threads : {2, 8}) {
            const std::vector<Vec3f> more = nodesWith(rods, threads);
            EXPECT_EQ(std::memcmp(one.data(), more.data(), one.size() * sizeof(Vec3f)), 0)
                << threads;
        }
    }
}

// Gravity 5 % up and back. Two rests of a strand lie more than 1 % of its length apart.
TEST(RestWarm, EndsInTheSameRestAsCold) {
    for (const Shape shape : shapes) {
        const int count = 20000;
        const Rods rods = randomHairs(shape, count, 25);
        RestState state;
        std::vector<Vec3f> cold(rods.nodeCount());
        std::vector<Vec3f> warm(rods.nodeCount());
        settleRods(rods, {}, state, cold);
        RodWorld heavier;
        heavier.gravity = {0, -1.05, 0};
        settleRods(rods, heavier, state, warm, {1e-5, true, 0});
        settleRods(rods, {}, state, warm, {1e-5, true, 0});
        int others = 0;
        for (std::size_t i = 0; i < rods.size(); ++i)
            others += rest::gap(rods, i, cold, warm) > 1e-2 ? 1 : 0;
        RecordProperty("others" + std::to_string(static_cast<int>(shape)), others);
        // A heavy curl may have a fold between the two loads: then it begins anew. Measured none;
        // 60 curls were elsewhere while warm solves went on from where they were.
        EXPECT_LE(others, 2) << static_cast<int>(shape);
    }
}

}  // namespace
}  // namespace kushi
