// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "render/paint.h"

#include <algorithm>
#include <array>
#include <cstddef>
#include <cstdint>
#include <vector>

namespace kushi {

/// Pixels of a square tile that things half cover, from near to far: each hides its share of what
/// the ones before have left. Pieces of one strand, which lie side by side, add up instead.
class Blend {
public:
    static constexpr std::uint32_t nobody = 0xffffffff;

    explicit Blend(int size)
        : size_(size), pixels_(static_cast<std::size_t>(size) * static_cast<std::size_t>(size)) {}

    void clear() {
        std::fill(pixels_.begin(), pixels_.end(), Pixel{});
        const int side = size_ / block;
        open_.assign(static_cast<std::size_t>(side) * static_cast<std::size_t>(side),
                     block * block);
    }

    /// Whether more would still be seen.
    bool isOpen(int x, int y) const { return at(x, y).left > opaque; }
    /// The same of any pixel in columns [left, right] and rows [top, bottom], or near there; what
    /// lies outside of the tile does not count.
    bool anyOpen(double left, double top, double right, double bottom) const;

    /// Adds color where `share` of the pixel is covered by a segment, named by its first node.
    void add(int x, int y, std::uint32_t node, float share, Float4 color);

    /// Light of what was added, in the first three.
    Float4 light(int x, int y) const { return at(x, y).light; }
    /// Share of what lies behind that is still seen.
    float left(int x, int y) const { return at(x, y).left; }

private:
    static constexpr int block = 8;

    /// In open_.
    std::size_t index(int column, int row) const {
        return static_cast<std::size_t>(row) * static_cast<std::size_t>(size_ / block) +
               static_cast<std::size_t>(column);
    }
    static constexpr float opaque = 1.0F / 512;

    struct Pixel {
        Float4 light{};
        float left = 1;               ///< after the last strand
        float before = 1;             ///< before it
        float share = 0;              ///< covered by it
        std::uint32_t node = nobody;  ///< its last segment
    };

    Pixel& at(int x, int y) {
        return pixels_[static_cast<std::size_t>(y) * static_cast<std::size_t>(size_) +
                       static_cast<std::size_t>(x)];
    }
    const Pixel& at(int x, int y) const {
        return pixels_[static_cast<std::size_t>(y) * static_cast<std::size_t>(size_) +
                       static_cast<std::size_t>(x)];
    }

    int size_;
    std::vector<Pixel> pixels_;
    std::vector<int> open_;  // pixels, by blocks
};

}  // namespace kushi
