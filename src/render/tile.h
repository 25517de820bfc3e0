// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <algorithm>
#include <array>
#include <bit>
#include <cstddef>
#include <cstdint>
#include <span>
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
/// comparison decides both, and among equals the lowest id stays. A border takes what lines spill,
/// so that they need not look where they write.
///
/// Two columns of four rows share a line of the processor's cache, as most hair hangs; where a
/// sample lies in memory is the sum of an offset by its column and one by its row.
class SampleTile {
public:
    using Key = std::int64_t;

    explicit SampleTile(int size)
        : size_(size),
          lines_(static_cast<std::size_t>(side()) * static_cast<std::size_t>(side()) / lineKeys) {
        for (int i = 0; i < side(); ++i) {
            columns_.push_back(i / 2 * lineKeys + i % 2);
            rows_.push_back(i / 4 * 4 * side() + i % 4 * 2);
        }
    }

    /// Nothing anywhere: id 0 behind all.
    void clear(int x, int y) {
        x_ = x;
        y_ = y;
        Line nothing;
        nothing.keys.fill(Key{1} << 62);
        std::fill(lines_.begin(), lines_.end(), nothing);
    }

    /// Place of the tile's first sample in the picture.
    int x() const { return x_; }
    int y() const { return y_; }
    int size() const { return size_; }

    /// Of a sample of the tile or its border.
    Key* at(int column, int row) { return keys() + columns()[column] + rows()[row]; }
    const Key* at(int column, int row) const {
        return lines_.front().keys.data() + columns()[column] + rows()[row];
    }

    /// The sample in a column and a row is keys()[columns()[column] + rows()[row]]; both reach
    /// `border` beyond the tile at either side.
    static constexpr int border = 4;
    Key* keys() { return lines_.front().keys.data(); }
    const std::ptrdiff_t* columns() const { return columns_.data() + border; }
    const std::ptrdiff_t* rows() const { return rows_.data() + border; }

    /// All of them in the order of memory, the border's too.
    std::span<const Key> all() const {
        return {lines_.front().keys.data(), lines_.size() * lineKeys};
    }

    /// The farthest key of a square of samples.
    ///
    /// size  a multiple of 4, as are column and row
    Key farthest(int column, int row, int size) const {
        // Positive numbers have the order of their bits, and for these there is an instruction.
        double most[4] = {};
        for (int y = row; y < row + size; y += 4) {
            const Key* key = at(column, y);
            for (int i = 0; i < 4 * size; i += 4) {
                for (int j = 0; j < 4; ++j) {
                    const auto value = std::bit_cast<double>(key[i + j]);
                    most[j] = most[j] < value ? value : most[j];
                }
            }
        }
        return std::bit_cast<Key>(std::max({most[0], most[1], most[2], most[3]}));
    }

    static Key key(std::int64_t depth, std::uint32_t id) {
        return (depth & ~std::int64_t{0xffffffff}) | static_cast<std::int64_t>(id);
    }
    static std::uint32_t id(Key key) { return static_cast<std::uint32_t>(key & 0xffffffff); }

private:
    static constexpr int lineKeys = 8;
    struct alignas(64) Line {
        std::array<Key, lineKeys> keys;
    };

    /// Whole blocks of four by four samples.
    int side() const { return (size_ + 3) / 4 * 4 + 2 * border; }

    int size_;
    std::vector<Line> lines_;
    std::vector<std::ptrdiff_t> columns_, rows_;
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
