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
            const SampleTile::Key* key = tile.at(x, y + j);
            for (int i = 0; i < side; ++i)
                ids |= SampleTile::id(key[i]);
        }
        return ids == 0;
    }

    Float4 mean(Palette& palette) const {
        Float4 sum{};
        for (int j = 0; j < side; ++j) {
            const SampleTile::Key* key = tile.at(x, y + j);
            for (int i = 0; i < side; ++i) {
                const Paint& paint = palette[SampleTile::id(key[i])];
                sum += paint.at(static_cast<float>(x + i), static_cast<float>(y + j));
            }
        }
        return sum / static_cast<float>(side * side);
    }
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
