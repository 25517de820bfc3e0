// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "render/projection.h"
#include "render/tile.h"

#include <cstddef>
#include <vector>

namespace kushi {

/// What a tile's samples show, as a depth buffer for things drawn pixel by pixel.
class SolidDepths {
public:
    /// Without anything in the tile.
    void clear() { pixels_.clear(); }
    /// supersample  samples per pixel along each axis
    void take(const SampleTile& tile, int supersample, const Projection& projection);

    /// Share of the pixel (x, y) of the tile in which something at the distance 1 / q is seen.
    float seen(int x, int y, float q) const {
        if (pixels_.empty()) return 1;
        const Range& range = pixels_[index(x, y)];
        if (q >= range.nearest) return 1;
        return q < range.farthest ? 0 : shareSeen(x, y, q);
    }

private:
    struct Range {
        float nearest, farthest;  // 1 / distance of the samples [1/m]; farthest 0 if one is empty
    };

    std::size_t index(int x, int y) const {
        return static_cast<std::size_t>(y) * static_cast<std::size_t>(side_) +
               static_cast<std::size_t>(x);
    }
    float shareSeen(int x, int y, float q) const;

    int side_ = 0;      // pixels
    int perPixel_ = 0;  // samples
    std::vector<Range> pixels_;
    std::vector<float> samples_;  // 1 / distance, pixel by pixel
};

}  // namespace kushi
