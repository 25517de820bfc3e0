// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "render/scene.h"
#include "render/tile.h"

#include <array>
#include <cstddef>

namespace kushi {

/// How far one sees into a tile at most, here and there: what lies beyond is known to be hidden
/// without a look at its samples.
class Horizon {
public:
    /// Takes in what the tile shows.
    void look(const SampleTile& tile, const Projection& projection);

    /// Whether it is certain that the tile's samples would stay as they are if this were drawn.
    bool hides(const SegmentBox& box) const {
        const Float4 none = {};
        const Float4 last = none + static_cast<float>(blocks - 1);
        const Int4 block =
            truncated(smaller(larger((box.sides - origin_) * perSample_, none), last));
        for (int row = block[1]; row <= block[3]; ++row) {
            for (int column = block[0]; column <= block[2]; ++column) {
                const std::size_t index =
                    static_cast<std::size_t>(row) * blocks + static_cast<std::size_t>(column);
                if (box.nearest >= farthest_[index]) return false;
            }
        }
        return true;
    }
    bool hides(const ScreenPolygon& polygon) const;

private:
    static constexpr int blocks = 8;  // along each side of the tile

    Float4 origin_{};      // x, y, x, y of the tile's first sample
    float perSample_ = 1;  // blocks
    std::array<float, static_cast<std::size_t>(blocks* blocks)> farthest_{};  // row by row, 1/m
};

}  // namespace kushi
