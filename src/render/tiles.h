// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "render/scene.h"
#include "render/tile.h"

#include <kushi/draw.h>

#include <cstdint>
#include <functional>
#include <span>

namespace kushi {

/// What may touch one tile, in ascending order.
struct TileItems {
    int x = 0, y = 0;                         ///< of the tile's first sample
    std::span<const std::uint32_t> segments;  ///< by their first node
    std::span<const std::uint32_t> triangles;
};

/// Does one tile; keeps what it needs for that from tile to tile.
using TileWorker = std::function<void(const TileItems&)>;

/// Whether a picture can be made of this.
bool drawable(const Strands& strands, const DrawOptions& options);

/// The samples of a picture in tiles of 64 x 64 pixels.
TileGrid gridOf(const DrawOptions& options);

/// Sorts the scene into tiles and gives each tile to one of `threads` workers, each of which runs
/// on one thread at a time. What a tile is given depends neither on that nor on the order of tiles.
void forEachTile(const Scene& scene, const TileGrid& grid, int threads,
                 const std::function<TileWorker()>& makeWorker);

}  // namespace kushi
