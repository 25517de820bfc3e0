// SPDX-License-Identifier: Apache-2.0
#include "render/paint.h"

#include "render/triangle.h"

#include <cmath>

namespace kushi {

namespace {

/// Moves what holds at a point of the picture to the centre of the tile's first sample.
Paint anchored(Float4 value, Float4 perX, Float4 perY, const ScreenPoint& at, int tileX,
               int tileY) {
    const auto x = static_cast<float>(tileX + 0.5 - at.x);
    const auto y = static_cast<float>(tileY + 0.5 - at.y);
    return {value + x * perX + y * perY, perX, perY};
}

}  // namespace

Paint paintOf(Rgb color) {
    return {.start = scaled(color, 1)};
}

Paint paintOf(const ScreenSegment& segment, Rgb first, Rgb last, int tileX, int tileY) {
    const ScreenPoint& a = segment.a;
    const ScreenPoint& b = segment.b;
    const Float4 atA = scaled(mixed(first, last, segment.from), a.q);
    const Float4 atB = scaled(mixed(first, last, segment.to), b.q);
    const double x = b.x - a.x;
    const double y = b.y - a.y;
    const double square = x * x + y * y;
    if (square < 1) return {.start = 0.5F * (atA + atB)};
    const Float4 step = (atB - atA) / static_cast<float>(square);
    return anchored(atA, step * static_cast<float>(x), step * static_cast<float>(y), a, tileX,
                    tileY);
}

Paint paintOf(const ScreenPolygon& polygon, const std::array<Rgb, 3>& colors, int tileX,
              int tileY) {
    std::array<Float4, 3> values;
    for (std::size_t i = 0; i < 3; ++i) {
        const auto& [at, weights] = polygon.corners[i];
        Rgb color;
        for (std::size_t j = 0; j < 3; ++j)
            color += colors[j] * static_cast<float>(weights[j]);
        values[i] = scaled(color, at.q);
    }
    const ScreenPoint& a = polygon.corners[0].at;
    const Plane plane(a, polygon.corners[1].at, polygon.corners[2].at);
    Float4 perX{};
    Float4 perY{};
    for (int i = 0; i < 4; ++i) {
        const Gradient slope = plane.gradient(values[0][i], values[1][i], values[2][i]);
        perX[i] = static_cast<float>(slope.perX);
        perY[i] = static_cast<float>(slope.perY);
    }
    return anchored(values[0], perX, perY, a, tileX, tileY);
}

}  // namespace kushi
