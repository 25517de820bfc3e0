// SPDX-License-Identifier: Apache-2.0
#include "render/line.h"
#include "render/paint.h"
#include "render/tiles.h"
#include "render/triangle.h"

#include <kushi/draw.h>

namespace kushi {

namespace {

/// Draws one tile after the other into its part of the image.
class Painter {
public:
    Painter(const Scene& scene, const TileGrid& grid, std::span<const Rgb> colors,
            const DrawOptions& options, Image& image)
        : scene_(scene),
          grid_(grid),
          colors_(colors),
          options_(options),
          image_(image),
          samples_(grid.tileSize()) {}

    void operator()(const TileItems& items) {
        if (items.segments.empty() && items.triangles.empty()) return;
        samples_.clear(items.x, items.y);
        paints_.assign(1, paintOf(options_.background));
        // Strands come in any order, so every segment is far from the last one in memory.
        constexpr std::size_t ahead = 12;
        for (std::size_t i = 0; i < items.segments.size(); ++i) {
            if (i + ahead < items.segments.size()) {
                scene_.prefetch(items.segments[i + ahead]);
                __builtin_prefetch(&colors_[items.segments[i + ahead]]);
            }
            drawSegment(items.segments[i]);
        }
        for (const std::uint32_t triangle : items.triangles)
            drawTriangle(triangle);
        resolve(samples_, paints_, options_.supersample, image_);
    }

private:
    std::uint32_t nextId() const { return static_cast<std::uint32_t>(paints_.size()); }

    void drawSegment(std::uint32_t node) {
        const std::optional<ScreenSegment> segment = scene_.segment(node);
        if (!segment) return;
        const Line line = lineBetween(segment->a, segment->b, scene_.projection(), grid_);
        if (line.first >= line.last) return;
        drawLine(samples_, line, nextId());
        paints_.push_back(paintOf(*segment, colors_[node], colors_[node + 1], samples_));
    }

    void drawTriangle(std::uint32_t index) {
        const ScreenPolygon polygon = scene_.triangle(index);
        if (polygon.size == 0) return;
        drawPolygon(samples_, polygon, scene_.projection(), nextId());
        std::array<Rgb, 3> colors;
        for (std::size_t i = 0; i < 3; ++i) {
            const Mesh& mesh = scene_.mesh();
            constexpr Rgb grey = {0.5F, 0.5F, 0.5F};
            colors[i] = mesh.colors.empty() ? grey : mesh.colors[mesh.triangles[index][i]];
        }
        paints_.push_back(paintOf(polygon, colors, samples_));
    }

    const Scene& scene_;
    const TileGrid& grid_;
    std::span<const Rgb> colors_;
    const DrawOptions& options_;
    Image& image_;
    SampleTile samples_;
    std::vector<Paint> paints_;
};

}  // namespace

Image draw(const Strands& strands, std::span<const Rgb> colors, const Mesh& head,
           const Camera& camera, const DrawOptions& options) {
    const bool headFits = head.colors.empty() || head.colors.size() == head.vertices.size();
    if (!drawable(strands, options) || colors.size() != strands.nodes.size() || !headFits) {
        return {};
    }
    const TileGrid grid = gridOf(options);
    Image image{.width = options.width, .height = options.height, .pixels = {}};
    image.pixels.assign(
        static_cast<std::size_t>(options.width) * static_cast<std::size_t>(options.height),
        options.background);
    const Projection projection(camera, grid.width, grid.height);
    if (!projection.valid()) return image;

    const Scene scene(strands, head, projection, options.threads);
    forEachTile(scene, grid, options.threads,
                [&]() -> TileWorker { return Painter(scene, grid, colors, options, image); });
    return image;
}

}  // namespace kushi
