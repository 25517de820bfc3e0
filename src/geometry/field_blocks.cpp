// SPDX-License-Identifier: Apache-2.0
#include "geometry/field_blocks.h"

#include "core/parallel.h"

#include <algorithm>

namespace kushi {
namespace {

Vec3f middleOf(const DistanceField& grid, int x, int y, int z) {
    const auto along = [](int i) {
        return static_cast<float>(FieldBlocks::side * i) + 0.5F * (FieldBlocks::side - 1);
    };
    return grid.origin + grid.spacing * Vec3f{along(x), along(y), along(z)};
}

}  // namespace

FieldBlocks blocksOf(const DistanceField& grid, const SolidTrees& trees, int threads) {
    FieldBlocks blocks;
    for (std::size_t k = 0; k < 3; ++k)
        blocks.size[k] = (grid.size[k] + FieldBlocks::side - 1) / FieldBlocks::side;
    const auto [columns, rows, layers] = blocks.size;
    blocks.middles.resize(blocks.index(0, 0, layers));
    blocks.nearest.resize(blocks.middles.size());
    // Along a row each block helps the next.
    const auto probeRow = [&, columns = columns, rows = rows](std::size_t row) {
        const int y = static_cast<int>(row) % rows, z = static_cast<int>(row) / rows;
        std::span<const Probe> last;
        std::uint32_t guess = 0;
        for (int x = 0; x < columns; ++x) {
            const std::size_t i = blocks.index(x, y, z);
            const Vec3f middle = middleOf(grid, x, y, z);
            Nearest& nearest = blocks.nearest[i];
            nearest = nearestIn(trees.surface, middle, guess);
            guess = nearest.triangle;
            blocks.middles[i] = probeOf(trees.surface, middle, nearest.distance, last);
            if (&trees.from(blocks.middles[i].inside) != &trees.surface) {
                nearest = nearestIn(trees.skin, middle, 0);
            }
            last = {&blocks.middles[i], 1};
        }
    };
    const auto count = static_cast<std::size_t>(rows) * static_cast<std::size_t>(layers);
    parallelFor(count, 1, threads, [&](std::size_t begin, std::size_t end) {
        for (std::size_t row = begin; row < end; ++row)
            probeRow(row);
    });
    return blocks;
}

std::vector<Vec3f> pointsAround(const FieldBlocks& blocks, int x, int y, int z) {
    std::vector<Vec3f> points;
    const auto [columns, rows, layers] = blocks.size;
    for (int k = std::max(z - 1, 0); k <= std::min(z + 1, layers - 1); ++k) {
        for (int j = std::max(y - 1, 0); j <= std::min(y + 1, rows - 1); ++j) {
            for (int i = std::max(x - 1, 0); i <= std::min(x + 1, columns - 1); ++i)
                points.push_back(blocks.nearest[blocks.index(i, j, k)].point);
        }
    }
    return points;
}

}  // namespace kushi
