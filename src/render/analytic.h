// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "render/area.h"
#include "render/blend.h"
#include "render/end_colors.h"
#include "render/palette.h"
#include "render/resolve_layers.h"
#include "render/sampler.h"
#include "render/solids.h"

#include <kushi/image.h>

#include <cstdint>
#include <optional>
#include <span>
#include <vector>

namespace kushi {

/// Draws one tile after the other into its part of the image, its alpha and mask: the mesh by
/// samples, before it the strands by the area of each pixel that they cover, from near to far.
class AnalyticPainter {
public:
    AnalyticPainter(const Scene& scene, const TileGrid& grid, const NodeColors& colors,
                    const DrawOptions& options, Image& image, LayeredImage* layers);

    void operator()(const TileItems& items);

private:
    /// A segment that may be seen, by its first node, and its place in ends_.
    struct SeenSegment {
        std::uint32_t node;
        std::size_t place;
    };

    void findOrder(const TileItems& items);
    /// Some segments of the order, one after the other.
    void drawGroup(std::span<const std::uint64_t> group);
    void drawSegment(std::uint32_t node, const ScreenSegment& segment, const EndColors::Ends& ends);
    /// Whether what lies before it leaves any of it to be seen.
    bool mayBeSeen(const ScreenSegment& segment) const;
    PixelPoint onPixels(const ScreenPoint& point) const;
    void blendInto(int left, int top);

    const Scene& scene_;
    const NodeColors& colors_;
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
    std::vector<std::uint64_t> order_;   // the nearest first: depth over node
    std::vector<SeenSegment> seen_;      // of a group, in its order
    std::vector<std::uint64_t> byNode_;  // node over index in seen_
    std::vector<std::uint32_t> nodes_;   // of them, ascending
    EndColors ends_;                     // theirs
};

}  // namespace kushi
