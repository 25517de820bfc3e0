// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "render/projection.h"
#include "render/tile.h"

#include <cstdint>

namespace kushi {

/// A line up to `widest` samples wide, as a walk along its longer axis, one column (or row) of
/// samples a step.
///
/// It owns the columns whose centre lies between its ends, that of its first end included, that of
/// its last not: of a polyline's segments along one axis exactly one owns each column, even at a
/// node or where the polyline turns. Across, a line of width w is w sqrt(1 + slope^2) samples
/// thick. Every column gets the whole part of that, in the middle of the line, and a share of the
/// columns, evenly spread, one sample more, on the nearer side: a line of length l covers l w
/// samples, give or take two columns, whatever its place and slope, and also where it is thinner
/// than a sample.
///
/// Positions are fixed-point numbers with 32 fractional bits, set up once for the whole line, so
/// that it covers the same samples however the picture is cut into tiles.
struct Line {
    static constexpr double widest = 2;

    bool alongY = false;        ///< whether the longer axis is y
    int first = 0, last = 0;    ///< columns [first, last) of the picture
    int whole = 1;              ///< samples in every column, 0 to 2
    std::int64_t row = 0;       ///< in column `first`: that of the samples' middle
    std::int64_t rowStep = 0;   ///< per column
    std::int64_t more = 0;      ///< columns from `first` to the first of those with a sample more
    std::int64_t moreStep = 0;  ///< from one of those to the next; 0 if there are none
    std::int64_t depth = 0;     ///< in column `first`, of Projection::fullDepth
    std::int64_t depthStep = 0;

    /// How far from the middle samples lie at most, in fixed point.
    std::int64_t reach() const { return (whole + std::int64_t{1}) << 31; }
};

/// Of the mean width of its ends.
///
/// grid   what lies outside of it along the longer axis is cut off
/// phase  where in their cycle the columns with a sample more begin; lines that lie side by side
///        should differ
Line lineBetween(const ScreenPoint& a, const ScreenPoint& b, const Projection& projection,
                 const TileGrid& grid, std::uint32_t phase = 0);

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
    const std::int64_t reach = line.reach();
    for (int strip = line.first >> shift; strip << shift < line.last; ++strip) {
        const LinePiece piece = pieceOf(line, strip << shift, (strip + 1) << shift);
        const std::int64_t end = piece.row + line.rowStep * (piece.size - 1);
        const std::int64_t low = std::max<std::int64_t>(std::min(piece.row, end) - reach, 0);
        const std::int64_t high = std::max(piece.row, end) + reach;
        const std::int64_t last = std::min(high >> (32 + shift), acrossTiles - 1);
        for (std::int64_t i = low >> (32 + shift); i <= last; ++i) {
            const int across = static_cast<int>(i);
            line.alongY ? visit(across, strip) : visit(strip, across);
        }
    }
}

}  // namespace kushi
