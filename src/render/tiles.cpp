// SPDX-License-Identifier: Apache-2.0
#include "render/tiles.h"

#include "core/parallel.h"
#include "render/line.h"
#include "render/tile_lists.h"
#include "render/triangle.h"

#include <atomic>
#include <thread>

namespace kushi {

namespace {

/// Items listed at a time, unless a single tile has more: 64 MB.
constexpr std::size_t listed = std::size_t{1} << 24U;

/// Tiles of the segments of strands [begin, end).
template <class Emit>
void enumerateSegments(const Scene& scene, const TileGrid& grid, std::size_t begin, std::size_t end,
                       const Emit& emit) {
    const int shift = grid.tileShift;
    const int columns = grid.columns();
    const int rows = grid.rows();
    for (std::size_t strand = begin; strand < end; ++strand) {
        const std::uint32_t tip = scene.strands().offsets[strand + 1];
        for (std::uint32_t node = scene.strands().offsets[strand]; node + 1 < tip; ++node) {
            const std::optional<ScreenSegment> segment = scene.segment(node);
            if (!segment) continue;

            // The tiles of the box around the segment, with half a sample to spare for its width.
            const auto [ax, bx] = std::minmax(segment->a.x, segment->b.x);
            const auto [ay, by] = std::minmax(segment->a.y, segment->b.y);
            const int left = std::max(floorToInt(ax - 1) >> shift, 0);
            const int right = std::min(floorToInt(bx + 1) >> shift, columns - 1);
            const int top = std::max(floorToInt(ay - 1) >> shift, 0);
            const int bottom = std::min(floorToInt(by + 1) >> shift, rows - 1);
            if (left >= right || top >= bottom) {
                // No box, or all of it is needed.
                for (int row = top; row <= bottom; ++row) {
                    for (int column = left; column <= right; ++column) {
                        emit(grid.index(column, row), node);
                    }
                }
                continue;
            }
            const Line line = lineBetween(segment->a, segment->b, scene.projection(), grid);
            forEachTile(line, grid,
                        [&](int column, int row) { emit(grid.index(column, row), node); });
        }
    }
}

/// Tiles of the triangles [begin, end).
template <class Emit>
void enumerateTriangles(const Scene& scene, const TileGrid& grid, std::size_t begin,
                        std::size_t end, const Emit& emit) {
    for (std::size_t i = begin; i < end; ++i) {
        const auto index = static_cast<std::uint32_t>(i);
        const TileBox box = tilesOf(scene.triangle(index), grid);
        for (int row = box.top; row < box.bottom; ++row) {
            for (int column = box.left; column < box.right; ++column) {
                emit(grid.index(column, row), index);
            }
        }
    }
}

std::size_t workersFor(int threads, std::size_t tiles) {
    const std::size_t wanted =
        threads > 0 ? static_cast<std::size_t>(threads) : std::thread::hardware_concurrency();
    return std::clamp<std::size_t>(wanted, 1, tiles);
}

}  // namespace

bool drawable(const Strands& strands, const DrawOptions& options) {
    const auto side = [](int pixels) { return pixels >= 1 && pixels <= 16384; };
    const int k = options.supersample;
    return side(options.width) && side(options.height) && (k == 1 || k == 2 || k == 4) &&
           !strands.offsets.empty() && strands.offsets.back() == strands.nodes.size();
}

TileGrid gridOf(const DrawOptions& options) {
    const int k = options.supersample;
    return {.width = options.width * k, .height = options.height * k, .tileShift = 6 + k / 2};
}

void forEachTile(const Scene& scene, const TileGrid& grid, int threads,
                 const std::function<TileWorker()>& makeWorker) {
    const auto segments = [&](std::size_t begin, std::size_t end, const auto& emit) {
        enumerateSegments(scene, grid, begin, end, emit);
    };
    const auto triangles = [&](std::size_t begin, std::size_t end, const auto& emit) {
        enumerateTriangles(scene, grid, begin, end, emit);
    };
    TileLists segmentLists(scene.strands().size(), grid.count(), threads, segments);
    TileLists triangleLists(scene.mesh().triangles.size(), grid.count(), threads, triangles);

    const std::size_t workers = workersFor(threads, grid.count());
    for (TileRange range; range.begin < grid.count(); range.begin = range.end) {
        // As many tiles as the lists have room for, but at least one.
        const auto load = [&](std::size_t tile) {
            return segmentLists.count(tile) + triangleLists.count(tile);
        };
        std::size_t items = load(range.begin);
        for (range.end = range.begin + 1; range.end < grid.count(); ++range.end) {
            items += load(range.end);
            if (items > listed) break;
        }
        segmentLists.fill(range, segments);
        triangleLists.fill(range, triangles);

        std::atomic<std::size_t> next{range.begin};
        parallelFor(workers, 1, threads, [&](std::size_t, std::size_t) {
            const TileWorker work = makeWorker();
            const auto columns = static_cast<std::size_t>(grid.columns());
            for (std::size_t tile = next++; tile < range.end; tile = next++) {
                work({.x = static_cast<int>(tile % columns) * grid.tileSize(),
                      .y = static_cast<int>(tile / columns) * grid.tileSize(),
                      .segments = segmentLists.items(tile),
                      .triangles = triangleLists.items(tile)});
            }
        });
    }
}

}  // namespace kushi
