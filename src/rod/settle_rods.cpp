// SPDX-License-Identifier: Apache-2.0
#include "core/parallel.h"
#include "rod/strand_batch.h"

#include <kushi/rods.h>

#include <algorithm>
#include <cmath>
#include <numeric>

namespace kushi {

namespace {

// Strands that one thread settles together.
constexpr std::size_t batchSize = 256;

// A batch's strands, and where their turns begin in RestState.
struct Batch {
    std::size_t first = 0, size = 0;  // of the order
    std::size_t turns = 0;
};

// Strands by their number of segments, else in their own order.
std::vector<std::uint32_t> bySegments(const Rods& rods) {
    std::vector<std::uint32_t> order(rods.size());
    std::iota(order.begin(), order.end(), 0U);
    std::stable_sort(order.begin(), order.end(), [&](std::uint32_t a, std::uint32_t b) {
        return rods.segments(a) < rods.segments(b);
    });
    return order;
}

std::vector<Batch> batchesOf(const Rods& rods, std::span<const std::uint32_t> order) {
    std::vector<Batch> batches;
    std::size_t turns = 0;
    for (std::size_t i = 0; i < order.size();) {
        const std::size_t segments = rods.segments(order[i]);
        std::size_t end = i;
        while (end < order.size() && end - i < batchSize && rods.segments(order[end]) == segments)
            ++end;
        batches.push_back({i, end - i, turns});
        turns += (end - i) * segments * turnsPerNode(rods);
        i = end;
    }
    return batches;
}

std::uint64_t layoutOf(const Rods& rods) {
    std::uint64_t layout = 0xcbf29ce484222325U ^ turnsPerNode(rods);
    for (const std::uint32_t offset : rods.offsets)
        layout = (layout ^ offset) * 0x100000001b3U;
    return layout;
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

RestReport settleRods(const Rods& rods, const RodWorld& world, RestState& state,
                      std::span<Vec3f> nodes, const RestOptions& options) {
    RestReport report;
    report.residuals.resize(rods.size());
    std::vector<std::uint8_t> settled(rods.size());
    const std::vector<std::uint32_t> order = bySegments(rods);
    const std::vector<Batch> batches = batchesOf(rods, order);
    const std::uint64_t layout = layoutOf(rods);
    const bool warm = options.warm && state.layout == layout;
    state.layout = layout;
    state.turns.resize(rods.offsets.back() * turnsPerNode(rods));

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
        const std::size_t each = rods.segments(batch.strands[0]) * turnsPerNode(rods);
        batch.turns = std::span(state.turns).subspan(one.turns, one.size * each);
        batch.warm = warm;
        batch.tolerance = options.tolerance;
        batch.nodes = nodes;
        batch.residuals = report.residuals;
        batch.states = settled;
        settleLanes(batch);

        // What floats could not settle.
        for (std::size_t i = 0; i < one.size; ++i) {
            if (settled[batch.strands[i]] != 0) continue;
            ++refined[begin];
            StrandBatch alone = batch;
            alone.strands = batch.strands.subspan(i, 1);
            alone.turns = batch.turns.subspan(i * each, each);
            settleReference(alone);
        }
    });
    report.refined = std::accumulate(refined.begin(), refined.end(), std::size_t{0});
    for (std::uint32_t i = 0; i < rods.size(); ++i) {
        if (settled[i] == 0) report.unsettled.push_back(i);
    }
    return report;
}

}  // namespace kushi
