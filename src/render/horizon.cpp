// SPDX-License-Identifier: Apache-2.0
#include "render/horizon.h"

namespace kushi {

void Horizon::look(const SampleTile& tile, const Projection& projection) {
    x_ = tile.x();
    y_ = tile.y();
    const int size = tile.size() / static_cast<int>(blocks);
    perSample_ = 1.0 / size;
    // To spare for rounding, for the id, and for what drawableDepth() moves: half a millimetre at a
    // metre.
    constexpr SampleTile::Key rounding = SampleTile::Key{1} << 41;
    std::size_t block = 0;
    for (int y = 0; y < tile.size(); y += size) {
        for (int x = 0; x < tile.size(); x += size)
            farthest_[block++] = projection.inverseDistance(tile.farthest(x, y, size) + rounding);
    }
}

bool Horizon::hides(const ScreenPolygon& polygon) const {
    if (polygon.size == 0) return true;
    ScreenPoint low = polygon.corners[0].at;
    ScreenPoint high = low;
    for (int i = 1; i < polygon.size; ++i) {
        const ScreenPoint at = polygon.corners[static_cast<std::size_t>(i)].at;
        low = {std::min(low.x, at.x), std::min(low.y, at.y), 0};
        high = {std::max(high.x, at.x), std::max(high.y, at.y), std::max(high.q, at.q)};
    }
    return hidesBox({low.x, high.x, low.y, high.y, high.q});
}

}  // namespace kushi
