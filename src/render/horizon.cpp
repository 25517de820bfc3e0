// SPDX-License-Identifier: Apache-2.0
#include "render/horizon.h"

namespace kushi {

void Horizon::look(const SampleTile& tile, const Projection& projection) {
    const auto x0 = static_cast<float>(tile.x());
    const auto y0 = static_cast<float>(tile.y());
    origin_ = Float4{x0, y0, x0, y0};
    const int size = tile.size() / blocks;
    perSample_ = 1.0F / static_cast<float>(size);
    // To spare for rounding, for the id, and for what drawableDepth() moves: half a millimetre at a
    // metre.
    constexpr SampleTile::Key rounding = SampleTile::Key{1} << 41;
    std::size_t block = 0;
    for (int y = 0; y < tile.size(); y += size) {
        for (int x = 0; x < tile.size(); x += size)
            farthest_[block++] = static_cast<float>(
                projection.inverseDistance(tile.farthest(x, y, size) + rounding));
    }
}

bool Horizon::hides(const ScreenPolygon& polygon) const {
    if (polygon.size == 0) return true;
    const auto numbers = [](const ScreenPoint& p) {
        return Float4{static_cast<float>(p.x), static_cast<float>(p.y), static_cast<float>(p.q)};
    };
    Float4 low = numbers(polygon.corners[0].at);
    Float4 high = low;
    for (int i = 1; i < polygon.size; ++i) {
        const Float4 at = numbers(polygon.corners[static_cast<std::size_t>(i)].at);
        low = smaller(low, at);
        high = larger(high, at);
    }
    // A sample to spare for rounding.
    const Float4 sides = {low[0] - 1, low[1] - 1, high[0] + 1, high[1] + 1};
    return hides(SegmentBox{sides, high[2]});
}

}  // namespace kushi
