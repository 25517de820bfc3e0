// SPDX-License-Identifier: Apache-2.0
#include "render/resolve.h"

#include <algorithm>

namespace kushi {

namespace {

/// The samples of one pixel.
struct PixelSamples {
    const SampleTile& tile;
    int x, y;  // the first one's place in the tile
    int side;

    bool empty() const {
        std::uint32_t ids = 0;
        for (int j = 0; j < side; ++j) {
            for (int i = 0; i < side; ++i)
                ids |= idAt(i, j);
        }
        return ids == 0;
    }

    /// Samples of one thing that lie below each other get the colour at their middle.
    Float4 mean(Palette& palette) const {
        Float4 sum{};
        for (int i = 0; i < side; ++i) {
            int end = 0;
            for (int j = 0; j < side; j = end) {
                const std::uint32_t id = idAt(i, j);
                for (end = j + 1; end < side && idAt(i, end) == id;)
                    ++end;
                const float middle = 0.5F * static_cast<float>(j + end - 1);
                sum += static_cast<float>(end - j) *
                       palette[id].at(static_cast<float>(x + i), static_cast<float>(y) + middle);
            }
        }
        return sum / static_cast<float>(side * side);
    }

    std::uint32_t idAt(int i, int j) const { return SampleTile::id(*tile.at(x + i, y + j)); }
};

}  // namespace

void resolve(const SampleTile& tile, Palette& palette, int supersample, Image& image) {
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
            const Float4 mean = samples.mean(palette);
            image.at(left + column, top + row) = {mean[0], mean[1], mean[2]};
        }
    }
}

}  // namespace kushi
