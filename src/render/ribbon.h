// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "render/scene.h"
#include "render/tile.h"

#include <cstdint>

namespace kushi {

/// What a segment covers where its width can be seen: a quadrilateral between the two nodes. At a
/// node where the strand goes on, both segments end on the same mitre, so that they share its edge
/// and leave no gap; where it ends, or turns back on the picture, the end is square.
///
/// node  the segment's first
ScreenPolygon ribbonOf(const Scene& scene, std::uint32_t node, const ScreenSegment& segment);

/// Draws what of a ribbon lies in the tile: the samples whose centre lies inside, as drawPolygon()
/// does, but faster where it is a few samples wide.
///
/// ribbon   of `segment`
void drawRibbon(SampleTile& tile, const ScreenPolygon& ribbon, const ScreenSegment& segment,
                const Projection& projection, std::uint32_t id);

}  // namespace kushi
