// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "render/line.h"
#include "render/ribbon.h"
#include "render/scene.h"
#include "render/tile.h"

#include <cstdint>

namespace kushi {

/// The line of a segment that is no ribbon.
///
/// node  its first
inline Line lineOf(const ScreenSegment& segment, std::uint32_t node, const Projection& projection,
                   const TileGrid& grid) {
    // Multiples of the golden ratio: evenly spread, for successive nodes and for all.
    return lineBetween(segment.a, segment.b, projection, grid, node * 0x9e3779b9U);
}

/// Draws what of a segment lies in the tile.
///
/// node  its first
inline void drawSegment(SampleTile& tile, const Scene& scene, std::uint32_t node,
                        const ScreenSegment& segment, const TileGrid& grid, std::uint32_t id) {
    if (scene.isRibbon(segment)) {
        drawRibbon(tile, ribbonOf(scene, node, segment), segment, scene.projection(), id);
    } else {
        drawLine(tile, lineOf(segment, node, scene.projection(), grid), id);
    }
}

}  // namespace kushi
