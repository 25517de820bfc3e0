// SPDX-License-Identifier: Apache-2.0
#include "core/parallel.h"
#include "pipeline/penetration.h"
#include "pipeline/push_all_out.h"

#include <kushi/push_out.h>

#include <atomic>

namespace kushi {

namespace {

constexpr std::size_t together = 64;  // strands of one thread

}  // namespace

Penetration penetrationOf(const DistanceField& solids, const Strands& groom, int threads) {
    const Obstacles obstacles = {nullptr, &solids};
    std::vector<double> depths(groom.size());
    parallelFor(groom.size(), together, threads, [&](std::size_t begin, std::size_t end) {
        for (std::size_t i = begin; i < end; ++i)
            depths[i] = deepestPoint(obstacles, groom.strand(i));
    });
    Penetration found;
    for (const double depth : depths)
        include(depth, found);
    return found;
}

Pushed pushOneOut(const DistanceField& solids, std::span<Vec3f> nodes) {
    return nodes.empty() ? Pushed::No : pushOut(solids, marginOf(solids), nodes);
}

PushOutReport pushAllOut(const DistanceField& solids, std::size_t count,
                         const std::function<std::span<Vec3f>(std::size_t)>& strand, int threads) {
    std::atomic<std::size_t> pushed{0};
    std::atomic<std::size_t> stuck{0};
    parallelFor(count, together, threads, [&](std::size_t begin, std::size_t end) {
        for (std::size_t i = begin; i < end; ++i) {
            const Pushed how = pushOneOut(solids, strand(i));
            pushed += how == Pushed::No ? 0 : 1;
            stuck += how == Pushed::Stuck ? 1 : 0;
        }
    });
    return {pushed, stuck};
}

PushOutReport pushOut(const DistanceField& solids, Strands& groom, int threads) {
    const auto strand = [&](std::size_t i) {
        const std::size_t first = groom.offsets[i];
        return std::span(groom.nodes).subspan(first, groom.offsets[i + 1] - first);
    };
    return pushAllOut(solids, groom.size(), strand, threads);
}

}  // namespace kushi
