// SPDX-License-Identifier: Apache-2.0
#include "render/analytic.h"
#include "render/palette.h"
#include "render/resolve.h"
#include "render/resolve_layers.h"
#include "render/sampler.h"
#include "render/tiles.h"

#include <kushi/draw.h>

#include <optional>
#include <utility>

namespace kushi {

namespace {

/// Draws one tile after the other into its part of the image, by samples.
class SamplePainter {
public:
    SamplePainter(const Scene& scene, const TileGrid& grid, const NodeColors& colors,
                  const DrawOptions& options, Image& image, LayeredImage* layers)
        : supersample_(options.supersample),
          image_(image),
          sampler_(scene, grid),
          palette_(scene, colors, options.background, options.supersample) {
        if (layers != nullptr) layers_.emplace(scene, options.supersample, *layers);
    }

    void operator()(const TileItems& items) {
        if (items.segments.empty() && items.triangles.empty()) return;
        sampler_.begin(items);
        palette_.begin(items);
        sampler_.drawTriangles(items);
        sampler_.drawSegments(items);
        resolve(sampler_.samples(), palette_, supersample_, image_);
        if (layers_) (*layers_)(sampler_.samples(), items);
    }

private:
    int supersample_;
    Image& image_;
    Sampler sampler_;
    Palette palette_;
    std::optional<LayerResolver> layers_;
};

bool canDraw(const Strands& strands, const Mesh& head, const DrawOptions& options) {
    const bool headFits = head.colors.empty() || head.colors.size() == head.vertices.size();
    return drawable(strands, options) && headFits;
}

/// Of colours that are there already.
NodeColors from(std::span<const Rgb> known) {
    return [known](std::span<const std::uint32_t> nodes, std::span<Rgb> colors) {
        for (std::size_t i = 0; i < nodes.size(); ++i)
            colors[i] = known[nodes[i]];
    };
}

/// layers  to be filled beside the image, or null
void drawInto(Image& image, LayeredImage* layers, const Strands& strands, const NodeColors& colors,
              const Mesh& head, const Camera& camera, const DrawOptions& options) {
    const TileGrid grid = gridOf(options);
    image = {.width = options.width, .height = options.height, .pixels = {}};
    image.pixels.assign(
        static_cast<std::size_t>(options.width) * static_cast<std::size_t>(options.height),
        options.background);
    const Projection projection(camera, grid.width, grid.height);
    if (!projection.valid()) return;

    const Scene scene(strands, head, projection, options);
    forEachTile(scene, grid, options.threads, [&]() -> TileWorker {
        if (options.stroke == Stroke::Analytic)
            return AnalyticPainter(scene, grid, colors, options, image, layers);
        return SamplePainter(scene, grid, colors, options, image, layers);
    });
}

void makeRoom(LayeredImage& layers, const DrawOptions& options, const Layers& wanted) {
    const auto pixels =
        static_cast<std::size_t>(options.width) * static_cast<std::size_t>(options.height);
    layers.alpha.assign(pixels, 0);
    if (wanted.depth) layers.depth.assign(pixels, LayeredImage::nothing);
    if (wanted.tangent) layers.tangent.assign(pixels, {});
    if (wanted.strand) layers.strand.assign(pixels, LayeredImage::noStrand);
    if (wanted.mask) layers.mask.assign(pixels, 0);
}

}  // namespace

Image draw(const Strands& strands, std::span<const Rgb> colors, const Mesh& head,
           const Camera& camera, const DrawOptions& options) {
    if (colors.size() != strands.nodes.size()) return {};
    return draw(strands, from(colors), head, camera, options);
}

Image draw(const Strands& strands, const NodeColors& colors, const Mesh& head, const Camera& camera,
           const DrawOptions& options) {
    Image image;
    if (canDraw(strands, head, options))
        drawInto(image, nullptr, strands, colors, head, camera, options);
    return image;
}

LayeredImage drawLayers(const Strands& strands, std::span<const Rgb> colors, const Mesh& head,
                        const Camera& camera, const DrawOptions& options, const Layers& wanted) {
    if (colors.size() != strands.nodes.size()) return {};
    return drawLayers(strands, from(colors), head, camera, options, wanted);
}

LayeredImage drawLayers(const Strands& strands, const NodeColors& colors, const Mesh& head,
                        const Camera& camera, const DrawOptions& options, const Layers& wanted) {
    LayeredImage layers;
    if (!canDraw(strands, head, options)) return layers;
    DrawOptions bare = options;
    bare.background = {0, 0, 0};
    if (options.stroke != Stroke::Analytic) {
        makeRoom(layers, options, wanted);
        drawInto(layers.image, &layers, strands, colors, head, camera, bare);
        return layers;
    }
    if (wanted.depth || wanted.tangent || wanted.strand) {
        bare.stroke = Stroke::Sampled;
        layers = drawLayers(strands, colors, head, camera, bare, wanted);
        bare.stroke = Stroke::Analytic;
    }
    LayeredImage soft;
    makeRoom(soft, options, {.mask = wanted.mask});
    drawInto(soft.image, &soft, strands, colors, head, camera, bare);
    layers.image = std::move(soft.image);
    layers.alpha = std::move(soft.alpha);
    layers.mask = std::move(soft.mask);
    return layers;
}

}  // namespace kushi
