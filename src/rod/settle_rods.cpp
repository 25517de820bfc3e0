// SPDX-License-Identifier: Apache-2.0
#include "core/parallel.h"
#include "rod/knots.h"
#include "rod/strand_batch.h"

#include <kushi/rods.h>

#include <algorithm>
#include <cmath>
#include <numeric>

namespace kushi {

namespace {

// Strands that one thread settles together: the more, the fewer lanes are idle in the end, and the
// fewer threads have work.
std::size_t batchSizeOf(const Rods& rods) {
    return std::clamp<std::size_t>(rods.size() / 64, 256, 1024) / turnsAbreast * turnsAbreast;
}

// A batch's strands in the order, and their turns in RestState.
struct Batch {
    std::size_t first = 0, size = 0;
    std::size_t firstTurn = 0, turns = 0;
};

// Strands by their number of segments, else in their own order.
std::vector<std::uint32_t> bySegments(const Rods& rods) {
    std::size_t most = 0;
    for (std::size_t i = 0; i < rods.size(); ++i)
        most = std::max(most, rods.segments(i));
    std::vector<std::uint32_t> next(most + 2);
    for (std::size_t i = 0; i < rods.size(); ++i)
        ++next[rods.segments(i) + 1];
    std::partial_sum(next.begin(), next.end(), next.begin());
    std::vector<std::uint32_t> order(rods.size());
    for (std::uint32_t i = 0; i < rods.size(); ++i)
        order[next[rods.segments(i)]++] = i;
    return order;
}

std::vector<Batch> batchesOf(const Rods& rods, std::span<const std::uint32_t> order) {
    std::vector<Batch> batches;
    std::size_t turns = 0;
    const std::size_t batchSize = batchSizeOf(rods);
    for (std::size_t i = 0; i < order.size();) {
        const std::size_t segments = rods.segments(order[i]);
        std::size_t end = i;
        while (end < order.size() && end - i < batchSize && rods.segments(order[end]) == segments)
            ++end;
        const std::size_t size = turnsSize(end - i, segments, turnsPerNode(rods));
        batches.push_back({i, end - i, turns, size});
        turns += size;
        i = end;
    }
    return batches;
}

// Of each rod's among those of all, and an end; none if there are none.
std::vector<std::uint32_t> firstTies(std::size_t rods, std::span<const Tie> ties) {
    if (ties.empty()) return {};
    std::vector<std::uint32_t> first(rods + 1);
    for (const Tie& tie : ties)
        ++first[tie.strand + 1];
    std::partial_sum(first.begin(), first.end(), first.begin());
    return first;
}

std::uint64_t layoutOf(const Rods& rods) {
    std::uint64_t layout = 0xcbf29ce484222325U ^ turnsPerNode(rods);
    for (const std::uint32_t offset : rods.offsets)
        layout = (layout ^ offset) * 0x100000001b3U;
    return layout;
}

RestReport settlePinned(const Rods& rods, const RodWorld& world, RestState& state,
                        std::span<Vec3f> nodes, const RestOptions& options) {
    RestReport report;
    report.residuals.resize(rods.size());
    std::vector<std::uint8_t> settled(rods.size());
    const std::vector<std::uint32_t> order = bySegments(rods);
    const std::vector<Batch> batches = batchesOf(rods, order);
    const std::uint64_t layout = layoutOf(rods);
    const bool warm = options.warm && state.layout == layout;
    state.layout = layout;
    if (!warm) state.histories.assign(rods.size(), History::Other);
    state.turns.resize(batches.empty() ? 0 : batches.back().firstTurn + batches.back().turns);

    const std::vector<std::uint32_t> ties = firstTies(rods.size(), world.ties);
    if (!warm || state.tieForces.size() != world.ties.size())
        state.tieForces.assign(world.ties.size(), {});

    std::vector<std::uint32_t> refined(batches.size());
    parallelFor(batches.size(), 1, options.threads, [&](std::size_t begin, std::size_t /*end*/) {
        const Batch& one = batches[begin];
        if (rods.segments(order[one.first]) == 0) {
            for (std::size_t i = one.first; i < one.first + one.size; ++i) {
                nodes[rods.firstNode(order[i])] = rods.roots[order[i]];
                settled[order[i]] = 1;
            }
            return;
        }
        StrandBatch batch;
        batch.rods = &rods;
        batch.world = &world;
        batch.strands = std::span(order).subspan(one.first, one.size);
        batch.turns = std::span(state.turns).subspan(one.firstTurn, one.turns);
        batch.firstTies = ties;
        batch.tieForces = state.tieForces;
        batch.warm = warm;
        batch.histories = state.histories;
        batch.tolerance = options.tolerance;
        batch.nodes = nodes;
        batch.residuals = report.residuals;
        batch.states = settled;
        settleLanes(batch);

        const auto left = static_cast<std::uint32_t>(
            std::ranges::count_if(batch.strands, [&](std::uint32_t i) { return settled[i] == 0; }));
        if (left == 0 || !options.refine) return;
        refined[begin] = left;
        settleReference(batch);
    });
    report.tieForces = state.tieForces;
    report.refined = std::accumulate(refined.begin(), refined.end(), std::size_t{0});
    for (std::uint32_t i = 0; i < rods.size(); ++i) {
        if (settled[i] == 0) report.unsettled.push_back(i);
    }
    return report;
}

}  // namespace

Frame frameAlong(Vec3d direction) {
    if (direction.z < -1 + 1e-12) return {0, 1, 0, 0};
    const double scale = 1 / std::sqrt(2 * (1 + direction.z));
    return {static_cast<float>((1 + direction.z) * scale), static_cast<float>(-direction.y * scale),
            static_cast<float>(direction.x * scale), 0};
}

Vec3d directionOf(const Frame& frame) {
    const double w = frame.w;
    const double x = frame.x;
    const double y = frame.y;
    const double z = frame.z;
    return normalized(
        Vec3d{2 * (x * z + w * y), 2 * (y * z - w * x), w * w - x * x - y * y + z * z});
}

std::vector<Frame> framesAtRest(const Rods& rods, const RestState& state) {
    std::vector<Frame> frames(rods.offsets.back());
    const std::vector<std::uint32_t> order = bySegments(rods);
    for (const Batch& batch : batchesOf(rods, order)) {
        for (std::size_t place = 0; place < batch.size; ++place) {
            const std::uint32_t strand = order[batch.first + place];
            const std::size_t segments = rods.segments(strand);
            for (std::size_t j = 1; j <= segments; ++j) {
                const auto number = [&](std::size_t which) {
                    return state.turns[batch.firstTurn + turnIndex(place, segments, 4, j, which)];
                };
                frames[rods.offsets[strand] + j - 1] = {number(0), number(1), number(2), number(3)};
            }
        }
    }
    return frames;
}

RestReport settleRods(const Rods& rods, const RodWorld& world, RestState& state,
                      std::span<Vec3f> nodes, const RestOptions& options) {
    const bool knotted =
        std::ranges::any_of(world.ties, [](const Tie& tie) { return tie.knot != Tie::none; });
    if (!knotted) return settlePinned(rods, world, state, nodes, options);
    const double reach = rods.lengths[world.ties[0].strand];
    return settleKnots(world.ties, reach, options.warm, [&](std::span<const Tie> ties, bool warm) {
        RodWorld now = world;
        now.ties = ties;
        RestOptions how = options;
        how.warm = warm;
        return settlePinned(rods, now, state, nodes, how);
    });
}

}  // namespace kushi
