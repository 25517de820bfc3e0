// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "core/float4.h"
#include "render/scene.h"

#include <kushi/color.h>

#include <array>

namespace kushi {

/// The colour of one thing over a tile. Colour divided by distance is linear over the picture, and
/// so is 1 / distance; their ratio is the colour, true to perspective.
struct Paint {
    Float4 start{};         ///< r q, g q, b q, q at the centre of the tile's first sample
    Float4 perX{}, perY{};  ///< per sample

    /// At the centre of the sample (x, y) of the tile.
    Float4 at(float x, float y) const {
        const Float4 value = start + x * perX + y * perY;
        return value / value[3];
    }
};

/// A colour times 1 / distance, and that.
inline Float4 scaled(Rgb color, double q) {
    const auto s = static_cast<float>(q);
    return Float4{color.r * s, color.g * s, color.b * s, s};
}

Paint paintOf(Rgb color);
/// b may be a's place: then their mean.
///
/// tileX, tileY  the tile's first sample
Paint paintOf(const ScreenSegment& segment, Rgb first, Rgb last, int tileX, int tileY);
/// colors  of the triangle's corners
Paint paintOf(const ScreenPolygon& polygon, const std::array<Rgb, 3>& colors, int tileX, int tileY);

}  // namespace kushi
