// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "render/area.h"
#include "render/blend.h"
#include "render/palette.h"
#include "render/resolve_layers.h"
#include "render/sampler.h"
#include "render/solids.h"

#include <kushi/image.h>

#include <optional>
#include <vector>

namespace kushi {

/// Draws one tile after the other into its part of the image, its alpha and mask: the mesh by
/// samples, before it the strands by the area of each pixel that they cover, from near to far.
class AnalyticPainter {
public:
    AnalyticPainter(const Scene& scene, const TileGrid& grid, std::span<const Rgb> colors,
                    const DrawOptions& options, Image& image, LayeredImage* layers);

    void operator()(const TileItems& items);

private:
    void findOrder(const TileItems& items);
    void drawSegment(std::uint32_t node, const ScreenSegment& segment);
    void blendInto(int left, int top);

    const Scene& scene_;
    std::span<const Rgb> colors_;
    int supersample_;
    Image& image_;
    LayeredImage* layers_;  // alpha and mask; or null
    Sampler sampler_;
    Palette palette_;
    std::optional<LayerResolver> meshLayers_;
    Horizon horizon_;
    SolidDepths solids_;
    AreaCoverage area_;
    Blend blend_;
    std::vector<std::uint64_t> order_;  // the nearest first: depth over node
};

}  // namespace kushi
