// SPDX-License-Identifier: Apache-2.0
#include "render/horizon.h"
#include "render/near_first.h"
#include "render/palette.h"
#include "render/resolve.h"
#include "render/stroke.h"
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
          supersample_(options.supersample),
          image_(image),
          samples_(grid.tileSize()),
          palette_(scene, colors, options.background) {}

    void operator()(const TileItems& items) {
        if (items.segments.empty() && items.triangles.empty()) return;
        samples_.clear(items.x, items.y);
        palette_.begin(items);
        drawTriangles(items);
        drawSegments(items);
        resolve(samples_, palette_, supersample_, image_);
    }

private:
    void drawTriangles(const TileItems& items) {
        order_.clear();
        for (std::size_t i = 0; i < items.triangles.size(); ++i) {
            const ScreenPolygon polygon = scene_.triangle(items.triangles[i]);
            if (polygon.size > 0) order_.add(static_cast<std::uint32_t>(i), polygon.nearest());
        }
        nearFirst([&](std::uint32_t i, bool mayBeHidden) {
            const ScreenPolygon polygon = scene_.triangle(items.triangles[i]);
            if (mayBeHidden && horizon_.hides(polygon)) return;
            drawPolygon(samples_, polygon, scene_.projection(), Palette::triangleId(items, i));
        });
    }

    void drawSegments(const TileItems& items) {
        horizon_.look(samples_, scene_.projection());
        // Strands come in any order, so every segment is far from the last one in memory.
        constexpr std::size_t ahead = 12;
        order_.clear();
        for (std::size_t i = 0; i < items.segments.size(); ++i) {
            if (i + ahead < items.segments.size()) scene_.prefetch(items.segments[i + ahead]);
            const std::optional<ScreenSegment> segment = scene_.segment(items.segments[i]);
            if (!segment || horizon_.hides(*segment)) continue;
            order_.add(static_cast<std::uint32_t>(i), segment->nearest());
        }
        nearFirst([&](std::uint32_t i, bool mayBeHidden) {
            const ScreenSegment segment = *scene_.segment(items.segments[i]);
            if (mayBeHidden && horizon_.hides(segment)) return;
            drawSegment(samples_, scene_, items.segments[i], segment, grid_, Palette::segmentId(i));
        });
    }

    /// Draws what is in order_, and takes another look at the horizon between its groups if there
    /// is so much that this may save more than it costs.
    template <class DrawThing>
    void nearFirst(const DrawThing& drawThing) {
        order_.sort();
        const bool looks = order_.size() > 100;
        for (std::size_t i = 0; i < NearFirst::groups; ++i) {
            const bool mayBeHidden = i > 0 && looks;
            if (mayBeHidden) horizon_.look(samples_, scene_.projection());
            for (const std::uint32_t thing : order_.group(i))
                drawThing(thing, mayBeHidden);
        }
    }

    const Scene& scene_;
    const TileGrid& grid_;
    int supersample_;
    Image& image_;
    SampleTile samples_;
    Horizon horizon_;
    NearFirst order_;
    Palette palette_;
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

    const Scene scene(strands, head, projection, options);
    forEachTile(scene, grid, options.threads,
                [&]() -> TileWorker { return Painter(scene, grid, colors, options, image); });
    return image;
}

}  // namespace kushi
