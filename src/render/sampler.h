// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "render/horizon.h"
#include "render/near_first.h"
#include "render/scene.h"
#include "render/tile.h"
#include "render/tiles.h"

namespace kushi {

/// Finds what the samples of a tile show, under the ids of Palette. What is hidden by what has been
/// drawn before is left out, so that begin(), drawTriangles() and drawSegments() come in this
/// order.
class Sampler {
public:
    Sampler(const Scene& scene, const TileGrid& grid)
        : scene_(scene), grid_(grid), samples_(grid.tileSize()) {}

    void begin(const TileItems& items) { samples_.clear(items.x, items.y); }
    void drawTriangles(const TileItems& items);
    void drawSegments(const TileItems& items);

    const SampleTile& samples() const { return samples_; }

private:
    template <class Ask, class DrawThing>
    void nearFirst(const Ask& ask, const DrawThing& drawThing);

    const Scene& scene_;
    const TileGrid& grid_;
    SampleTile samples_;
    Horizon horizon_;
    NearFirst order_;
};

}  // namespace kushi
