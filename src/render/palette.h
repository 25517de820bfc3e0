// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "render/paint.h"
#include "render/rounding.h"
#include "render/tile.h"
#include "render/tiles.h"

#include <cstdint>
#include <span>
#include <vector>

namespace kushi {

/// The colours of what is drawn in a tile, by id: 0 is the background, then come the tile's
/// segments and then its triangles, each in the order of their list. Only what is shown is mixed,
/// as most things are hidden by others.
class Palette {
public:
    Palette(const Scene& scene, std::span<const Rgb> colors, Rgb background)
        : scene_(scene), colors_(colors), background_(paintOf(background)) {}

    static std::uint32_t segmentId(std::size_t index) {
        return static_cast<std::uint32_t>(index + 1);
    }
    static std::uint32_t triangleId(const TileItems& items, std::size_t index) {
        return static_cast<std::uint32_t>(items.segments.size() + index + 1);
    }

    /// Turns to another tile, whose lists must outlive its painting.
    void begin(const TileItems& items);

    /// Mixes the colours of what samples show, in the order of ids, which is that of memory.
    ///
    /// supersample  samples per pixel along each axis
    void mixFor(const SampleTile& samples, int supersample);

    /// Of an id that samples show, at the centre of the sample (x, y) of the tile.
    Float4 at(std::uint32_t id, float x, float y) const {
        const Float4 color = paints_[id].at(x, y);
        return roundings_.empty() ? color : roundings_[id].at(x, y) * color;
    }

private:
    Paint segmentPaint(std::size_t index);
    void makeRound(std::size_t index, const ScreenSegment& segment);
    Paint trianglePaint(std::uint32_t index) const;

    const Scene& scene_;
    std::span<const Rgb> colors_;
    Paint background_;
    TileItems items_;
    int supersample_ = 1;
    std::vector<Paint> paints_;
    std::vector<Rounding> roundings_;  // as paints_; none where no strand is wide enough
    std::vector<std::uint8_t> shown_;
};

}  // namespace kushi
