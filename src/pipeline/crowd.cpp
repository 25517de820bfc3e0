// SPDX-License-Identifier: Apache-2.0
#include "pipeline/crowd.h"

#include "core/parallel.h"

#include <algorithm>
#include <cmath>
#include <numbers>

namespace kushi {

namespace {

constexpr float voxelSize = 0.005F;  // m
constexpr std::size_t shares = 4;    // grids that are filled side by side

}  // namespace

void appendThick(const Strands& strands, double standFor, std::vector<ThickStrand>& all) {
    const double times = std::sqrt(standFor);
    for (std::size_t i = 0; i < strands.size(); ++i)
        all.push_back({strands.strand(i), times * strands.diameters[strands.offsets[i]]});
}

Voxels voxelsFor(std::span<const ThickStrand> strands) {
    std::vector<Vec3f> ends;
    for (const ThickStrand& strand : strands) {
        const Bounds box = boundsOf(strand.nodes);
        ends.insert(ends.end(), {box.low, box.high});
    }
    return voxelsAround(ends, voxelSize);
}

Density densityOf(std::span<const ThickStrand> strands, const Voxels& voxels, int threads) {
    std::vector<Density> parts(shares, Density(voxels));
    const std::size_t each = (strands.size() + shares - 1) / shares;
    parallelFor(shares, 1, threads, [&](std::size_t begin, std::size_t /*end*/) {
        const std::size_t first = std::min(begin * each, strands.size());
        for (const auto& [nodes, diameter] :
             strands.subspan(first, std::min(each, strands.size() - first)))
            parts[begin].add(nodes, std::numbers::pi / 4 * diameter * diameter);
    });
    for (std::size_t i = 1; i < shares; ++i)
        parts[0].add(parts[i]);
    return std::move(parts[0]);
}

}  // namespace kushi
