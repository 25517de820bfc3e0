// SPDX-License-Identifier: Apache-2.0
#include "render/analytic.h"
#include "render/palette.h"
#include "render/resolve.h"
#include "render/sampler.h"
#include "render/tiles.h"

#include <kushi/draw.h>

namespace kushi {

namespace {

/// Draws one tile after the other into its part of the image, by samples.
class SamplePainter {
public:
    SamplePainter(const Scene& scene, const TileGrid& grid, std::span<const Rgb> colors,
                  const DrawOptions& options, Image& image)
        : supersample_(options.supersample),
          image_(image),
          sampler_(scene, grid),
          palette_(scene, colors, options.background) {}

    void operator()(const TileItems& items) {
        if (items.segments.empty() && items.triangles.empty()) return;
        sampler_.begin(items);
        palette_.begin(items);
        sampler_.drawTriangles(items);
        sampler_.drawSegments(items);
        resolve(sampler_.samples(), palette_, supersample_, image_);
    }

private:
    int supersample_;
    Image& image_;
    Sampler sampler_;
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
    forEachTile(scene, grid, options.threads, [&]() -> TileWorker {
        if (options.stroke == Stroke::Analytic)
            return AnalyticPainter(scene, grid, colors, options, image);
        return SamplePainter(scene, grid, colors, options, image);
    });
    return image;
}

}  // namespace kushi
