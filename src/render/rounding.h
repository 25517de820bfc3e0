// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "render/area.h"

#include <algorithm>
#include <cmath>

namespace kushi {

/// Makes a strand round where its width can be seen: brighter in its middle than at its edges, and
/// as bright as ever on average. In cells, which are samples or pixels.
struct Rounding {
    float start = 0, perX = 0, perY = 0;  ///< -1 at one edge of the strand, 1 at the other
    float strength = 0;

    /// Times the strand's colour, at the centre of the cell (x, y).
    float at(float x, float y) const {
        const float across = std::clamp(start + x * perX + y * perY, -1.0F, 1.0F);
        return 1 + strength * (1.0F / 3 - across * across);
    }
};

/// a, b    ends of a segment [cells, from the first one's corner]
/// width   [cells]
/// pixel   [cells]: strands up to two pixels wide stay flat, from four on they are wholly round
inline Rounding roundingOf(PixelPoint a, PixelPoint b, double width, double pixel) {
    constexpr double most = 0.8;
    const double strength = most * std::min(1.0, 0.5 * width / pixel - 1);
    const double x = b.x - a.x;
    const double y = b.y - a.y;
    const double size = std::sqrt(x * x + y * y);
    if (!(strength > 0 && size > 1e-6)) return {};
    const double perX = -2 * y / (size * width);
    const double perY = 2 * x / (size * width);
    return {static_cast<float>(perX * (0.5 - a.x) + perY * (0.5 - a.y)), static_cast<float>(perX),
            static_cast<float>(perY), static_cast<float>(strength)};
}

}  // namespace kushi
