// SPDX-License-Identifier: Apache-2.0
#include "render/resolve.h"

#include <algorithm>
#include <array>
#include <cstddef>
#include <cstdint>

namespace kushi {

namespace {

/// The ids of one pixel's samples, column by column.
template <int side>
using PixelIds = std::array<std::uint32_t, static_cast<std::size_t>(side* side)>;

template <int side>
PixelIds<side> idsAt(const SampleTile& tile, int x, int y) {
    PixelIds<side> ids;
    std::size_t i = 0;
    for (int column = x; column < x + side; ++column) {
        for (int row = y; row < y + side; ++row)
            ids[i++] = SampleTile::id(*tile.at(column, row));
    }
    return ids;
}

/// Samples of one thing that lie below each other get the colour at their middle.
template <int side>
Float4 mean(const PixelIds<side>& ids, Palette& palette, int x, int y) {
    Float4 sum{};
    std::size_t next = 0;
    for (int column = x; column < x + side; ++column) {
        int end = 0;
        for (int row = 0; row < side; row = end) {
            const std::uint32_t id = ids[next++];
            for (end = row + 1; end < side && ids[next] == id; ++end)
                ++next;
            const float middle = static_cast<float>(y) + 0.5F * static_cast<float>(row + end - 1);
            sum +=
                static_cast<float>(end - row) * palette.at(id, static_cast<float>(column), middle);
        }
    }
    return sum / static_cast<float>(side * side);
}

template <int side>
void resolvePixels(const SampleTile& tile, Palette& palette, Image& image) {
    const int left = tile.x() / side;
    const int top = tile.y() / side;
    const int columns = std::min(tile.size() / side, image.width - left);
    const int rows = std::min(tile.size() / side, image.height - top);
    for (int row = 0; row < rows; ++row) {
        for (int column = 0; column < columns; ++column) {
            const int x = column * side;
            const int y = row * side;
            const PixelIds<side> ids = idsAt<side>(tile, x, y);
            std::uint32_t any = 0;
            for (const std::uint32_t id : ids)
                any |= id;
            if (any == 0) continue;
            const Float4 color = mean<side>(ids, palette, x, y);
            image.at(left + column, top + row) = {color[0], color[1], color[2]};
        }
    }
}

}  // namespace

void resolve(const SampleTile& tile, Palette& palette, int supersample, Image& image) {
    palette.mixFor(tile);
    switch (supersample) {
        case 1:
            return resolvePixels<1>(tile, palette, image);
        case 2:
            return resolvePixels<2>(tile, palette, image);
        default:
            return resolvePixels<4>(tile, palette, image);
    }
}

}  // namespace kushi
