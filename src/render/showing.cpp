// SPDX-License-Identifier: Apache-2.0
#include "render/horizon.h"
#include "render/stroke.h"
#include "render/tiles.h"
#include "render/triangle.h"

#include <kushi/draw.h>

#include <atomic>

namespace kushi {

namespace {

// What a sample shows. Where it is at the same depth, what is marked wins over
// what is not.
constexpr std::uint32_t markedId = 1;
constexpr std::uint32_t otherId = 2;

/// Counts one tile after the other.
class Counter {
public:
    Counter(const Scene& scene, const TileGrid& grid, std::span<const std::uint8_t> marked,
            std::atomic<std::size_t>& seen, std::atomic<std::size_t>& bare)
        : scene_(scene),
          grid_(grid),
          marked_(marked),
          seen_(seen),
          bare_(bare),
          samples_(grid.tileSize()) {}

    void operator()(const TileItems& items) {
        if (items.triangles.empty()) return;
        samples_.clear(items.x, items.y);
        for (const std::uint32_t triangle : items.triangles) {
            drawPolygon(samples_, scene_.triangle(triangle), scene_.projection(),
                        marked_[triangle] != 0 ? markedId : otherId);
        }
        const std::size_t bare = countMarked();
        bare_ += bare;
        if (bare == 0) return;
        horizon_.look(samples_, scene_.projection());
        for (const std::uint32_t node : items.segments) {
            const std::optional<ScreenSegment> segment = scene_.segment(node);
            if (!segment || horizon_.hides(*scene_.box(node))) continue;
            drawSegment(samples_, scene_, node, *segment, grid_, 0);
        }
        seen_ += countMarked();
    }

private:
    std::size_t countMarked() const {
        std::size_t count = 0;
        const int columns = std::min(samples_.size(), grid_.width - samples_.x());
        const int rows = std::min(samples_.size(), grid_.height - samples_.y());
        for (int row = 0; row < rows; ++row) {
            for (int column = 0; column < columns; ++column) {
                const SampleTile::Key key = *samples_.at(column, row);
                count += static_cast<std::size_t>(SampleTile::id(key) == markedId);
            }
        }
        return count;
    }

    const Scene& scene_;
    const TileGrid& grid_;
    std::span<const std::uint8_t> marked_;
    std::atomic<std::size_t>& seen_;
    std::atomic<std::size_t>& bare_;
    SampleTile samples_;
    Horizon horizon_;
};

}  // namespace

Showing countShowing(const Strands& strands, const Mesh& head, std::span<const std::uint8_t> marked,
                     const Camera& camera, const DrawOptions& options) {
    if (!drawable(strands, options) || marked.size() != head.triangles.size()) return {};
    const TileGrid grid = gridOf(options);
    const Projection projection(camera, grid.width, grid.height);
    if (!projection.valid()) return {};

    DrawOptions counted = options;
    if (counted.stroke == Stroke::Analytic) counted.stroke = Stroke::Sampled;
    const Scene scene(strands, head, projection, counted);
    std::atomic<std::size_t> seen{0};
    std::atomic<std::size_t> bare{0};
    forEachTile(scene, grid, options.threads,
                [&]() -> TileWorker { return Counter(scene, grid, marked, seen, bare); });
    return {.seen = seen, .bare = bare};
}

}  // namespace kushi
