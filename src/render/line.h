// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "render/projection.h"
#include "render/tile.h"

#include <cstdint>

namespace kushi {

/// A line one sample wide, as a walk along its longer axis, one column (or row) of samples a step.
///
/// It owns the columns whose centre lies between its ends, that of its first end included, that of
/// its last not: of a polyline's segments along one axis exactly one owns each column, even at a
/// node or where the polyline turns. In each column it covers the sample that it passes. As that
/// alone would make slanting lines thinner, in a share sqrt(1 + slope^2) - 1 of the columns, evenly
/// spread, it covers the second nearest too: a line of length l covers l samples, give or take two,
/// whatever its place and slope.
///
/// Positions are fixed-point numbers with 32 fractional bits, set up once for the whole line, so
/// that it covers the same samples however the picture is cut into tiles.
struct Line {
    bool alongY = false;        ///< whether the longer axis is y
    int first = 0, last = 0;    ///< columns [first, last) of the picture
    std::int64_t row = 0;       ///< in column `first`; the sample covered is the floor
    std::int64_t rowStep = 0;   ///< per column
    std::uint32_t doubled = 0;  ///< share of the columns with two samples, times 2^32
    std::int64_t depth = 0;     ///< in column `first`, of Projection::fullDepth
    std::int64_t depthStep = 0;
};

/// grid  what lies outside of it along the longer axis is cut off
Line lineBetween(const ScreenPoint& a, const ScreenPoint& b, const Projection& projection,
                 const TileGrid& grid);

/// The piece of a line over some columns.
struct LinePiece {
    int first = 0, size = 0;  ///< columns; size <= 0 if none
    std::int64_t row = 0;     ///< in column `first`
};

/// The piece of `line` over the columns [begin, end).
inline LinePiece pieceOf(const Line& line, int begin, int end) {
    const int first = std::max(line.first, begin);
    return {first, std::min(line.last, end) - first,
            line.row + line.rowStep * (first - line.first)};
}

/// Draws what of the line lies in the tile.
void drawLine(SampleTile& tile, const Line& line, std::uint32_t id);

/// Calls visit(column, row) for each tile that the line may touch, once.
template <class Visit>
void forEachTile(const Line& line, const TileGrid& grid, Visit&& visit) {
    const int shift = grid.tileShift;
    const std::int64_t acrossTiles = line.alongY ? grid.columns() : grid.rows();
    constexpr std::int64_t one = std::int64_t{1} << 32;
    for (int strip = line.first >> shift; strip << shift < line.last; ++strip) {
        const LinePiece piece = pieceOf(line, strip << shift, (strip + 1) << shift);
        const std::int64_t end = piece.row + line.rowStep * (piece.size - 1);
        const std::int64_t low = std::max<std::int64_t>(std::min(piece.row, end) - one, 0);
        const std::int64_t high = std::max(piece.row, end) + one;
        const std::int64_t last = std::min(high >> (32 + shift), acrossTiles - 1);
        for (std::int64_t i = low >> (32 + shift); i <= last; ++i) {
            const int across = static_cast<int>(i);
            line.alongY ? visit(across, strip) : visit(strip, across);
        }
    }
}

}  // namespace kushi
