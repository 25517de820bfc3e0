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
    void look(const SampleTile& tile, const Projection& projection);

    /// Whether it is certain that the tile's samples would stay as they are if this were drawn.
    bool hides(const ScreenSegment& segment) const {
        const ScreenPoint& a = segment.a;
        const ScreenPoint& b = segment.b;
        const double margin = segment.margin();
        return hidesBox({std::min(a.x, b.x) - margin, std::max(a.x, b.x) + margin,
                         std::min(a.y, b.y) - margin, std::max(a.y, b.y) + margin,
                         std::max(a.q, b.q)});
    }
    bool hides(const ScreenPolygon& polygon) const;

private:
    struct Box {
        double left, right, top, bottom;  // samples of the picture
        double nearest;                   // 1 / distance [1/m]
    };

    bool hidesBox(const Box& box) const {
        const std::size_t left = block(box.left - x_);
        const std::size_t right = block(box.right - x_);
        const std::size_t top = block(box.top - y_);
        const std::size_t bottom = block(box.bottom - y_);
        for (std::size_t row = top; row <= bottom; ++row) {
            for (std::size_t column = left; column <= right; ++column) {
                if (box.nearest >= farthest_[row * blocks + column]) return false;
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
    double perSample_ = 1;                            // blocks
    std::array<double, blocks * blocks> farthest_{};  // row by row, 1 / distance [1/m]
};

}  // namespace kushi
