// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "render/scene.h"
#include "render/tile.h"

#include <algorithm>
#include <array>
#include <cstddef>

namespace kushi {

/// How far one sees into a tile at most, here and there: what lies beyond is known to be hidden
/// without a look at its samples.
class Horizon {
public:
    /// Takes in what the tile shows.
    void look(const SampleTile& tile);

    /// Whether it is certain that the tile's samples would stay as they are if this were drawn.
    bool hides(const ScreenSegment& segment, const Projection& projection) const {
        const auto& [a, b, from, to] = segment;
        return hides(
            {std::min(a.x, b.x), std::max(a.x, b.x), std::min(a.y, b.y), std::max(a.y, b.y)},
            projection.depth(std::max(a.q, b.q)));
    }
    bool hides(const ScreenPolygon& polygon, const Projection& projection) const;

private:
    struct Box {
        double left, right, top, bottom;  // samples of the picture
    };

    bool hides(const Box& box, double nearestDepth) const {
        // Lines cover samples up to one away from them.
        constexpr double margin = 1;
        const std::size_t left = block(box.left - margin - x_);
        const std::size_t right = block(box.right + margin - x_);
        const std::size_t top = block(box.top - margin - y_);
        const std::size_t bottom = block(box.bottom + margin - y_);
        // A unit of depth to spare, for rounding.
        const auto nearest = static_cast<SampleTile::Key>(drawableDepth(nearestDepth) - 0x1p32);
        for (std::size_t row = top; row <= bottom; ++row) {
            for (std::size_t column = left; column <= right; ++column) {
                if (nearest <= farthest_[row * blocks + column]) return false;
            }
        }
        return true;
    }
    std::size_t block(double sample) const {
        return static_cast<std::size_t>(std::clamp(sample * perSample_, 0.0, lastBlock));
    }

    static constexpr std::size_t blocks = 8;  // along each side of the tile

    static constexpr double lastBlock = blocks - 1;

    double x_ = 0, y_ = 0;
    double perSample_ = 1;                                     // blocks
    std::array<SampleTile::Key, blocks * blocks> farthest_{};  // row by row
};

}  // namespace kushi
