// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <vector>

namespace kushi {

/// The picture's samples, cut into square tiles.
struct TileGrid {
    int width = 0, height = 0;  ///< samples
    int tileShift = 0;          ///< 2^tileShift samples are a tile's side

    int tileSize() const { return 1 << tileShift; }
    int columns() const { return (width + tileSize() - 1) >> tileShift; }
    int rows() const { return (height + tileSize() - 1) >> tileShift; }
    std::size_t count() const {
        return static_cast<std::size_t>(columns()) * static_cast<std::size_t>(rows());
    }
    std::size_t index(int column, int row) const {
        return static_cast<std::size_t>(row) * static_cast<std::size_t>(columns()) +
               static_cast<std::size_t>(column);
    }
};

/// For every sample of one tile the nearest thing: 30 bits of depth over 32 bits of id, so that one
/// comparison decides both, and among equals the lowest id stays. A border two samples wide takes
/// what lines spill, so that they need not look where they write.
class SampleTile {
public:
    using Key = std::int64_t;

    explicit SampleTile(int size)
        : size_(size),
          stride_(size + 2 * border),
          keys_(static_cast<std::size_t>(stride_) * static_cast<std::size_t>(stride_)) {}

    /// Nothing anywhere: id 0 behind all.
    void clear(int x, int y) {
        x_ = x;
        y_ = y;
        std::fill(keys_.begin(), keys_.end(), Key{1} << 62);
    }

    /// Place of the tile's first sample in the picture.
    int x() const { return x_; }
    int y() const { return y_; }
    int size() const { return size_; }

    std::ptrdiff_t stride() const { return stride_; }
    /// Of a sample of the tile or its border.
    Key* at(int column, int row) { return keys_.data() + offset(column, row); }
    const Key* at(int column, int row) const { return keys_.data() + offset(column, row); }

    static Key key(std::int64_t depth, std::uint32_t id) {
        return (depth & ~std::int64_t{0xffffffff}) | static_cast<std::int64_t>(id);
    }
    static std::uint32_t id(Key key) { return static_cast<std::uint32_t>(key & 0xffffffff); }

private:
    static constexpr int border = 2;

    std::ptrdiff_t offset(int column, int row) const {
        return (row + border) * stride_ + column + border;
    }

    int size_;
    std::ptrdiff_t stride_;
    std::vector<Key> keys_;
    int x_ = 0, y_ = 0;
};

/// Depth as things drawn may have it: before the background, with room for rounding at both ends.
inline double drawableDepth(double depth) {
    return std::clamp(depth, 0x1p40, 0x1p62 - 0x1p40);
}

/// The largest integer <= x, for |x| < 2^31; much faster than std::floor on a plain x86-64.
inline int floorToInt(double x) {
    const int truncated = static_cast<int>(x);
    return truncated - static_cast<int>(x < truncated);
}
/// The smallest integer >= x, for |x| < 2^31.
inline int ceilToInt(double x) {
    return -floorToInt(-x);
}

}  // namespace kushi
