// SPDX-License-Identifier: Apache-2.0
#include "render/horizon.h"

#include <algorithm>

namespace kushi {

void Horizon::look(const SampleTile& tile) {
    x_ = tile.x();
    y_ = tile.y();
    blockSize_ = tile.size() / blocks;
    for (auto& row : farthest_)
        row.fill(0);
    for (int y = 0; y < tile.size(); ++y) {
        auto& farthest = farthest_[static_cast<std::size_t>(y / blockSize_)];
        for (int block = 0; block < blocks; ++block) {
            const SampleTile::Key* key = tile.at(block * blockSize_, y);
            SampleTile::Key most = farthest[static_cast<std::size_t>(block)];
            for (int i = 0; i < blockSize_; ++i)
                most = std::max(most, key[i]);
            farthest[static_cast<std::size_t>(block)] = most;
        }
    }
}

bool Horizon::hides(const ScreenSegment& segment, const Projection& projection) const {
    const auto& [a, b, from, to] = segment;
    // A unit of depth to spare for the rounding of lines; likewise two samples around them.
    constexpr double unit = 0x1p32;
    constexpr double margin = 2;
    const double nearest = drawableDepth(projection.depth(std::max(a.q, b.q))) - unit;
    const auto nearestKey = static_cast<SampleTile::Key>(nearest);

    const auto block = [&](double sample, int origin) {
        return std::clamp(floorToInt(sample - origin) / blockSize_, 0, blocks - 1);
    };
    const int left = block(std::min(a.x, b.x) - margin, x_);
    const int right = block(std::max(a.x, b.x) + margin, x_);
    const int top = block(std::min(a.y, b.y) - margin, y_);
    const int bottom = block(std::max(a.y, b.y) + margin, y_);
    for (int row = top; row <= bottom; ++row) {
        for (int column = left; column <= right; ++column) {
            const SampleTile::Key farthest =
                farthest_[static_cast<std::size_t>(row)][static_cast<std::size_t>(column)];
            if (nearestKey <= farthest) return false;
        }
    }
    return true;
}

}  // namespace kushi
