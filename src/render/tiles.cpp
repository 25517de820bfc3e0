// SPDX-License-Identifier: Apache-2.0
#include "render/tiles.h"

#include "core/parallel.h"
#include "render/stroke.h"
#include "render/tile_lists.h"
#include "render/triangle.h"

#include <atomic>
#include <cmath>
#include <thread>
#include <vector>

namespace kushi {

namespace {

/// Items listed at a time, unless a single tile has more: 64 MB.
constexpr std::size_t listed = std::size_t{1} << 24U;

/// Tiles of the segments. Most touch a single one, which is remembered.
class SegmentTiles {
public:
    SegmentTiles(const Scene& scene, const TileGrid& grid)
        : scene_(scene), grid_(grid), single_(scene.strands().nodes.size(), none) {}

    /// Those of strands [begin, end); to be called before recall().
    template <class Emit>
    void find(std::size_t begin, std::size_t end, const Emit& emit) {
        const auto& offsets = scene_.strands().offsets;
        for (std::size_t strand = begin; strand < end; ++strand) {
            for (std::uint32_t node = offsets[strand]; node + 1 < offsets[strand + 1]; ++node) {
                std::uint32_t& single = single_[node];
                forEachTileOf(node, [&](std::size_t tile) {
                    single = single == none ? static_cast<std::uint32_t>(tile) : several;
                    emit(tile, node);
                });
            }
        }
    }

    /// The same once more.
    template <class Emit>
    void recall(std::size_t begin, std::size_t end, const Emit& emit) const {
        const auto& offsets = scene_.strands().offsets;
        for (std::uint32_t node = offsets[begin]; node < offsets[end]; ++node) {
            const std::uint32_t single = single_[node];
            if (single < several) {
                emit(single, node);
            } else if (single == several) {
                forEachTileOf(node, [&](std::size_t tile) { emit(tile, node); });
            }
        }
    }

private:
    static constexpr std::uint32_t none = 0xffffffff;
    static constexpr std::uint32_t several = 0xfffffffe;

    /// A test for tiles that come within `margin` of the line through a segment that has a length.
    auto nearLine(const ScreenSegment& segment, double margin) const {
        const double x = segment.b.x - segment.a.x;
        const double y = segment.b.y - segment.a.y;
        const double side = grid_.tileSize();
        const double limit =
            margin * std::sqrt(x * x + y * y) + 0.5 * side * (std::abs(x) + std::abs(y));
        return [=, at = segment.a](int column, int row) {
            const double toX = (column + 0.5) * side - at.x;
            const double toY = (row + 0.5) * side - at.y;
            return std::abs(x * toY - y * toX) <= limit;
        };
    }

    template <class Visit>
    void forEachTileOf(std::uint32_t node, const Visit& visit) const {
        // The tiles of the box around the segment.
        const std::optional<SegmentBox> box = scene_.box(node);
        if (!box) return;
        const Int4 sides = truncated(box->sides) >> grid_.tileShift;
        const int left = std::max(sides[0], 0);
        const int top = std::max(sides[1], 0);
        const int right = std::min(sides[2], grid_.columns() - 1);
        const int bottom = std::min(sides[3], grid_.rows() - 1);
        if (left >= right || top >= bottom) {
            // No box, or all of it is needed.
            for (int row = top; row <= bottom; ++row) {
                for (int column = left; column <= right; ++column)
                    visit(grid_.index(column, row));
            }
            return;
        }
        const ScreenSegment segment = *scene_.segment(node);
        if (scene_.isRibbon(segment)) {
            const auto near = nearLine(segment, segment.margin());
            for (int row = top; row <= bottom; ++row) {
                for (int column = left; column <= right; ++column) {
                    if (near(column, row)) visit(grid_.index(column, row));
                }
            }
            return;
        }
        const Line line = lineOf(segment, node, scene_.projection(), grid_);
        forEachTile(line, grid_, [&](int column, int row) { visit(grid_.index(column, row)); });
    }

    const Scene& scene_;
    const TileGrid& grid_;
    std::vector<std::uint32_t> single_;  // by the segment's first node
};

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
           options.widen > 0 && options.widen <= 1e6F && !strands.offsets.empty() &&
           strands.offsets.back() == strands.nodes.size();
}

TileGrid gridOf(const DrawOptions& options) {
    const int k = options.supersample;
    return {.width = options.width * k, .height = options.height * k, .tileShift = 6 + k / 2};
}

void forEachTile(const Scene& scene, const TileGrid& grid, int threads,
                 const std::function<TileWorker()>& makeWorker) {
    SegmentTiles segmentTiles(scene, grid);
    const auto find = [&](std::size_t begin, std::size_t end, const auto& emit) {
        segmentTiles.find(begin, end, emit);
    };
    const auto recall = [&](std::size_t begin, std::size_t end, const auto& emit) {
        segmentTiles.recall(begin, end, emit);
    };
    const auto triangles = [&](std::size_t begin, std::size_t end, const auto& emit) {
        enumerateTriangles(scene, grid, begin, end, emit);
    };
    TileLists segmentLists(scene.strands().size(), grid.count(), threads, find);
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
        segmentLists.fill(range, recall);
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
