// SPDX-License-Identifier: Apache-2.0
#include "render/paint.h"

#include "render/triangle.h"

#include <algorithm>
#include <cmath>

namespace kushi {

namespace {

Float4 scaled(Rgb color, double q) {
    const auto s = static_cast<float>(q);
    return Float4{color.r * s, color.g * s, color.b * s, s};
}

/// Moves what holds at a point of the picture to the centre of the tile's first sample.
Paint anchored(Float4 value, Float4 perX, Float4 perY, const ScreenPoint& at,
               const SampleTile& tile) {
    const auto x = static_cast<float>(tile.x() + 0.5 - at.x);
    const auto y = static_cast<float>(tile.y() + 0.5 - at.y);
    return {value + x * perX + y * perY, perX, perY};
}

Rgb mix(Rgb a, Rgb b, double share) {
    const auto s = static_cast<float>(share);
    return a * (1 - s) + b * s;
}

/// The samples of one pixel.
struct PixelSamples {
    const SampleTile& tile;
    int x, y;  // the first one's place in the tile
    int side;

    bool empty() const {
        std::uint32_t ids = 0;
        for (int j = 0; j < side; ++j) {
            const SampleTile::Key* key = tile.at(x, y + j);
            for (int i = 0; i < side; ++i)
                ids |= SampleTile::id(key[i]);
        }
        return ids == 0;
    }

    Float4 mean(std::span<const Paint> paints) const {
        Float4 sum{};
        for (int j = 0; j < side; ++j) {
            const SampleTile::Key* key = tile.at(x, y + j);
            for (int i = 0; i < side; ++i) {
                const Paint& paint = paints[SampleTile::id(key[i])];
                sum += paint.at(static_cast<float>(x + i), static_cast<float>(y + j));
            }
        }
        return sum / static_cast<float>(side * side);
    }
};

}  // namespace

Paint paintOf(Rgb color) {
    return {.start = scaled(color, 1)};
}

Paint paintOf(const ScreenSegment& segment, Rgb first, Rgb last, const SampleTile& tile) {
    const ScreenPoint& a = segment.a;
    const ScreenPoint& b = segment.b;
    const Float4 atA = scaled(mix(first, last, segment.from), a.q);
    const Float4 atB = scaled(mix(first, last, segment.to), b.q);
    const double x = b.x - a.x;
    const double y = b.y - a.y;
    const bool alongY = std::abs(y) > std::abs(x);
    const double run = alongY ? y : x;
    if (std::abs(run) < 1) return {.start = 0.5F * (atA + atB)};
    const Float4 step = (atB - atA) / static_cast<float>(run);
    return anchored(atA, alongY ? Float4{} : step, alongY ? step : Float4{}, a, tile);
}

Paint paintOf(const ScreenPolygon& polygon, const std::array<Rgb, 3>& colors,
              const SampleTile& tile) {
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
    return anchored(values[0], perX, perY, a, tile);
}

void resolve(const SampleTile& tile, std::span<const Paint> paints, int supersample, Image& image) {
    const int side = tile.size() / supersample;
    const int left = tile.x() / supersample;
    const int top = tile.y() / supersample;
    const int columns = std::min(side, image.width - left);
    const int rows = std::min(side, image.height - top);
    for (int row = 0; row < rows; ++row) {
        for (int column = 0; column < columns; ++column) {
            const PixelSamples samples = {tile, column * supersample, row * supersample,
                                          supersample};
            if (samples.empty()) continue;
            const Float4 mean = samples.mean(paints);
            image.at(left + column, top + row) = {mean[0], mean[1], mean[2]};
        }
    }
}

}  // namespace kushi
