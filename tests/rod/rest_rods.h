// SPDX-License-Identifier: Apache-2.0
//
// Rods to test with: of unit length and unit EI at the origin, so that the weight is w L^3 / EI.
#pragma once

#include "core/random.h"
#include "rod/strand_batch.h"

#include <kushi/rods.h>

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <span>
#include <string>
#include <vector>

namespace kushi::rest {

inline void addRod(Rods& rods, Frame clamp, double gamma, int segments, std::uint64_t key = 1) {
    rods.roots.push_back({0, 0, 0});
    rods.clamps.push_back(clamp);
    rods.lengths.push_back(1);
    rods.bending.push_back(1);
    rods.twisting.push_back(2.0F / 3);
    rods.weights.push_back(static_cast<float>(gamma));
    rods.keys.push_back(key);
    rods.offsets.push_back(rods.offsets.back() + static_cast<std::uint32_t>(segments));
}

// Natural curvature for all segments that have none yet.
inline void curl(Rods& rods, Vec3d curvature) {
    rods.naturalCurvature.resize(rods.offsets.back(),
                                 {static_cast<float>(curvature.x), static_cast<float>(curvature.y),
                                  static_cast<float>(curvature.z)});
}

// Segments that grow from the root: segment j ends at (j / n)^1.5.
inline void grade(Rods& rods) {
    rods.segmentLengths.clear();
    for (std::size_t i = 0; i < rods.size(); ++i) {
        const auto n = static_cast<double>(rods.segments(i));
        for (std::size_t j = 0; j < rods.segments(i); ++j) {
            rods.segmentLengths.push_back(
                static_cast<float>(std::pow(static_cast<double>(j + 1) / n, 1.5) -
                                   std::pow(static_cast<double>(j) / n, 1.5)));
        }
    }
}

// The frame in the x-y plane with d3 = (cos, sin, 0) of the angle above the horizontal and d2 = z.
inline Frame planarClamp(double angle) {
    // d1 = d2 x d3 = (-sin, cos, 0): first z to x about y, then d1 and d2 about it, then the angle.
    const double half = 0.5 * angle;
    const double c = std::cos(half);
    const double s = std::sin(half);
    // Turn about z by the angle, times (1, 1, 1, 1) / 2, which takes d1, d2, d3 to y, z, x.
    return {static_cast<float>(0.5 * (c - s)), static_cast<float>(0.5 * (c - s)),
            static_cast<float>(0.5 * (c + s)), static_cast<float>(0.5 * (c + s))};
}

struct Settled {
    std::vector<Vec3f> nodes;
    std::vector<std::vector<float>> turns;  // of each strand, node by node
    std::vector<float> residuals;
    std::vector<std::uint8_t> states;
    std::vector<Vec3f> tieForces;

    Vec3f tip(const Rods& rods, std::size_t strand) const {
        return nodes[rods.firstNode(strand) + rods.segments(strand)];
    }
    std::span<const float> turnsOf(std::size_t strand) const { return turns[strand]; }
};

// By one of the two kernels, without the other's help.
inline Settled settleBy(void (*kernel)(const StrandBatch&), const Rods& rods, const RodWorld& world,
                        double tolerance) {
    Settled result;
    result.nodes.resize(rods.nodeCount());
    result.turns.resize(rods.size());
    result.residuals.resize(rods.size());
    result.states.resize(rods.size());
    std::vector<History> histories(rods.size());
    result.tieForces.resize(world.ties.size());
    std::vector<std::uint32_t> firstTies(world.ties.empty() ? 0 : rods.size() + 1);
    for (std::size_t i = 0; i < firstTies.size(); ++i)
        firstTies[i] = static_cast<std::uint32_t>(
            std::ranges::count_if(world.ties, [i](const Tie& tie) { return tie.strand < i; }));
    std::vector<std::uint32_t> strands(rods.size());
    for (std::size_t i = 0; i < rods.size(); ++i)
        strands[i] = static_cast<std::uint32_t>(i);
    for (std::size_t i = 0; i < rods.size();) {
        std::size_t end = i + 1;
        while (end < rods.size() && rods.segments(end) == rods.segments(i))
            ++end;
        StrandBatch batch;
        batch.rods = &rods;
        batch.world = &world;
        batch.strands = std::span(strands).subspan(i, end - i);
        const std::size_t each = turnsPerNode(rods);
        std::vector<float> turns(turnsSize(end - i, rods.segments(i), each));
        batch.turns = turns;
        batch.histories = histories;
        batch.firstTies = firstTies;
        batch.tieForces = result.tieForces;
        batch.tolerance = tolerance;
        batch.nodes = result.nodes;
        batch.residuals = result.residuals;
        batch.states = result.states;
        kernel(batch);
        for (std::size_t place = 0; place < end - i; ++place)
            for (std::size_t j = 1; j <= rods.segments(i); ++j)
                for (std::size_t which = 0; which < each; ++which)
                    result.turns[i + place].push_back(
                        turns[turnIndex(place, rods.segments(i), each, j, which)]);
        i = end;
    }
    return result;
}

// As users do: floats, and the reference for what they cannot settle.
inline Settled settle(const Rods& rods, const RodWorld& world) {
    Settled result;
    result.nodes.resize(rods.nodeCount());
    RestState state;
    RestReport report = settleRods(rods, world, state, result.nodes);
    result.residuals = std::move(report.residuals);
    result.states.assign(rods.size(), 1);
    for (const std::uint32_t strand : report.unsettled)
        result.states[strand] = 0;
    return result;
}

inline double distance(Vec3f a, Vec3f b) {
    return std::hypot(static_cast<double>(a.x) - b.x, static_cast<double>(a.y) - b.y,
                      static_cast<double>(a.z) - b.z);
}

// Largest distance between the nodes of a strand in two results.
inline double gap(const Rods& rods, std::size_t strand, std::span<const Vec3f> a,
                  std::span<const Vec3f> b) {
    double largest = 0;
    for (std::size_t j = 0; j <= rods.segments(strand); ++j) {
        const std::size_t node = rods.firstNode(strand) + j;
        // A node that is not a number is at no distance.
        const double d = distance(a[node], b[node]);
        largest = d <= largest ? largest : d;
    }
    return largest;
}

enum class Shape { Straight, Wavy, Curly, Tight };

// Hairs of a class: any clamp from 80 degrees down to all but straight up, w L^3 / EI between 0.1
// and 3000, natural curvature times length up to 6, 20 and 40.
inline Rods randomHairs(Shape shape, int count, int segments) {
    const double low[] = {0, 1, 6, 20};
    const double high[] = {0, 6, 20, 40};
    const auto which = static_cast<std::size_t>(shape);
    Rods rods;
    for (int i = 0; i < count; ++i) {
        const std::uint64_t key = mixKey(static_cast<std::uint64_t>(i), 77 + which);
        const auto draw = [&](std::uint64_t salt, double from, double to) {
            return from + (to - from) * uniform(mixKey(key, salt));
        };
        const double up = radians(draw(1, -80, 89.9));
        const double around = radians(draw(2, -180, 180));
        const double gamma = std::pow(10, draw(3, -1, std::log10(3000.0)));
        addRod(rods,
               frameAlong({std::cos(up) * std::cos(around), std::sin(up),
                           std::cos(up) * std::sin(around)}),
               gamma, segments, key);
        if (shape == Shape::Straight) continue;
        const double bend = draw(4, low[which], high[which]);
        const double along = draw(5, -0.6, 0.6);
        const double about = radians(draw(6, -180, 180));
        const double across = bend * std::sqrt(1 - along * along);
        curl(rods, {across * std::cos(about), across * std::sin(about), bend * along});
    }
    return rods;
}

}  // namespace kushi::rest
