// SPDX-License-Identifier: Apache-2.0
#include "render/line.h"

#include <cmath>
#include <cstddef>
#include <utility>

namespace kushi {

namespace {

constexpr double one = 0x1p32;      // fixed-point
constexpr double fewest = 0x1p-20;  // columns are no more than 2^16

std::int64_t toFixed(double x) {
    return static_cast<std::int64_t>(x * one);
}

/// n / d rounded up, for n > 0, d > 0.
std::int64_t stepsUp(std::int64_t n, std::int64_t d) {
    return (n + d - 1) / d;
}

/// Cuts a piece down to the columns where low <= row < high.
void clip(LinePiece& piece, std::int64_t step, std::int64_t low, std::int64_t high) {
    const std::int64_t end = piece.row + step * (piece.size - 1);
    if (std::min(piece.row, end) >= low && std::max(piece.row, end) < high) return;
    if (std::max(piece.row, end) < low || std::min(piece.row, end) >= high) {
        piece.size = 0;
        return;
    }
    // Now the line crosses a limit, so step is not 0.
    std::int64_t enter = 0;
    std::int64_t leave = piece.size;
    if (step > 0) {
        if (piece.row < low) enter = stepsUp(low - piece.row, step);
        if (end >= high) leave = stepsUp(high - piece.row, step);
    } else {
        if (piece.row >= high) enter = stepsUp(piece.row - high + 1, -step);
        if (end < low) leave = stepsUp(piece.row - low + 1, -step);
    }
    piece.first += static_cast<int>(enter);
    piece.size = static_cast<int>(leave - enter);
    piece.row += step * enter;
}

/// What walks take from the tile: where samples lie by columns along the line, by rows across it.
struct Offsets {
    SampleTile::Key* keys;
    const std::ptrdiff_t* along;  // from the piece's first column on
    const std::ptrdiff_t* across;

    void cover(std::ptrdiff_t column, std::ptrdiff_t row, SampleTile::Key key) const {
        SampleTile::Key& sample = keys[along[column] + across[row]];
        sample = std::min(sample, key);
    }
};

/// The inner loop: most of a picture's time is spent here. Depth is tested by a minimum and not by
/// a branch, as its outcome is close to a coin's toss.
///
/// row  in the first column; the sample covered is the floor
void walk(Offsets tile, std::int64_t row, std::ptrdiff_t size, std::int64_t depth, const Line& line,
          std::uint32_t id) {
    // Copies, as the compiler must take what is written to the tile for a part of the line.
    const std::int64_t rowStep = line.rowStep;
    const std::int64_t depthStep = line.depthStep;
    for (std::ptrdiff_t i = 0; i < size; ++i) {
        tile.cover(i, row >> 32, SampleTile::key(depth, id));
        row += rowStep;
        depth += depthStep;
    }
}

/// The columns with a sample more, on the side of the whole ones where the line's middle is.
///
/// row, depth  in the line's first column
/// skipped     columns from there to the piece
void walkMore(Offsets tile, std::int64_t row, std::int64_t skipped, std::int64_t size,
              std::int64_t depth, const Line& line, std::uint32_t id) {
    const std::int64_t step = line.moreStep;
    if (step == 0) return;
    std::int64_t at = line.more;
    const std::int64_t begin = skipped << 32;
    if (at < begin) at += stepsUp(begin - at, step) * step;
    const std::int64_t end = (skipped + size) << 32;
    const std::ptrdiff_t whole = line.whole;
    for (; at < end; at += step) {
        const std::int64_t column = at >> 32;
        const std::int64_t low = row + line.rowStep * column;
        const bool above = (low & (std::int64_t{1} << 31)) != 0;
        tile.cover(column - skipped, (low >> 32) + (above ? whole : -1),
                   SampleTile::key(depth + line.depthStep * column, id));
    }
}

}  // namespace

Line lineBetween(const ScreenPoint& a, const ScreenPoint& b, const Projection& projection,
                 const TileGrid& grid, std::uint32_t phase) {
    Line line;
    line.alongY = std::abs(b.y - a.y) > std::abs(b.x - a.x);
    const double start = line.alongY ? a.y : a.x;
    const double stop = line.alongY ? b.y : b.x;
    const double run = stop - start;
    const double startAcross = line.alongY ? a.x : a.y;
    const double rise = line.alongY ? b.x - a.x : b.y - a.y;
    const int columns = line.alongY ? grid.height : grid.width;

    // Centres in [start, stop) going up, in (stop, start] going down.
    const double limit = columns;
    const auto within = [limit](double x) { return std::clamp(x, 0.0, limit); };
    if (run > 0) {
        line.first = ceilToInt(within(start - 0.5));
        line.last = ceilToInt(within(stop - 0.5));
    } else {
        line.first = floorToInt(within(stop + 0.5));
        line.last = floorToInt(within(start + 0.5));
    }
    if (line.first >= line.last) return line;

    const double inverse = 1 / run;
    const double slope = rise * inverse;
    const double way = line.first + 0.5 - start;
    line.row = toFixed(startAcross + way * slope);
    line.rowStep = toFixed(slope);
    const double thickness = 0.5 * (a.width + b.width) * std::sqrt(1 + slope * slope);
    line.whole = static_cast<int>(thickness);
    const double share = thickness - line.whole;
    if (share > fewest) {
        // The columns c where (c + 1) share + phase passes a whole number.
        const double passed = line.first * share + phase / one;
        const double period = 1 / share;
        line.more = toFixed((1 - (passed - static_cast<int>(passed))) * period);
        line.moreStep = toFixed(period);
    }

    // Only lines of more than one step use the depth's step, so it need not overflow.
    const double depthA = drawableDepth(projection.depth(a.q));
    const double depthB = drawableDepth(projection.depth(b.q));
    line.depth = static_cast<std::int64_t>(depthA + way * inverse * (depthB - depthA));
    line.depthStep = static_cast<std::int64_t>((depthB - depthA) * std::clamp(inverse, -1.0, 1.0));
    return line;
}

void drawLine(SampleTile& tile, const Line& line, std::uint32_t id) {
    const int origin = line.alongY ? tile.y() : tile.x();
    const int across = line.alongY ? tile.x() : tile.y();
    LinePiece piece = pieceOf(line, origin, origin + tile.size());
    if (piece.size <= 0) return;

    // From the rows before the tile to those after it whose samples may lie in it.
    const std::int64_t reach = line.reach();
    const std::int64_t tileRow = static_cast<std::int64_t>(across) << 32;
    piece.row -= tileRow;
    clip(piece, line.rowStep, -reach, (static_cast<std::int64_t>(tile.size()) << 32) + reach);
    if (piece.size <= 0) return;

    const std::int64_t skipped = piece.first - line.first;
    const std::int64_t depth = line.depth + line.depthStep * skipped;
    const int column = piece.first - origin;
    const Offsets offsets = {tile.keys(), (line.alongY ? tile.rows() : tile.columns()) + column,
                             line.alongY ? tile.columns() : tile.rows()};
    // That of the lowest of the whole samples, as far below the middle as the highest is above it.
    const std::int64_t toLowest = (line.whole - std::int64_t{1}) << 31;
    for (std::int64_t i = 0; i < line.whole; ++i)
        walk(offsets, piece.row - toLowest + (i << 32), piece.size, depth, line, id);
    walkMore(offsets, line.row - tileRow - toLowest, skipped, piece.size, line.depth, line, id);
}

}  // namespace kushi
