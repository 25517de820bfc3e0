// SPDX-License-Identifier: Apache-2.0
#include "render/solids.h"

#include <algorithm>

namespace kushi {

void SolidDepths::take(const SampleTile& tile, int supersample, const Projection& projection) {
    side_ = tile.size() / supersample;
    perPixel_ = supersample * supersample;
    const auto pixels = static_cast<std::size_t>(side_) * static_cast<std::size_t>(side_);
    pixels_.resize(pixels);
    samples_.resize(pixels * static_cast<std::size_t>(perPixel_));
    std::size_t next = 0;
    for (int y = 0; y < side_; ++y) {
        for (int x = 0; x < side_; ++x) {
            Range range = {0, 1e30F};
            for (int i = 0; i < perPixel_; ++i) {
                const SampleTile::Key key =
                    *tile.at(x * supersample + i % supersample, y * supersample + i / supersample);
                const float q = SampleTile::id(key) == 0
                                    ? 0
                                    : static_cast<float>(projection.inverseDistance(key));
                samples_[next++] = q;
                range.nearest = std::max(range.nearest, q);
                range.farthest = std::min(range.farthest, q);
            }
            pixels_[index(x, y)] = range;
        }
    }
}

float SolidDepths::shareSeen(int x, int y, float q) const {
    const float* first = samples_.data() + index(x, y) * static_cast<std::size_t>(perPixel_);
    const auto seen = std::count_if(first, first + perPixel_, [q](float s) { return q >= s; });
    return static_cast<float>(seen) / static_cast<float>(perPixel_);
}

}  // namespace kushi
