// SPDX-License-Identifier: Apache-2.0
#include "render/line.h"

#include <cmath>
#include <cstddef>
#include <utility>

namespace kushi {

namespace {

constexpr double one = 0x1p32;  // fixed-point

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
void walk(Offsets tile, const LinePiece& piece, std::int64_t depth, const Line& line,
          std::uint32_t id) {
    // Copies, as the compiler must take what is written to the tile for a part of the line.
    const std::int64_t rowStep = line.rowStep;
    const std::int64_t depthStep = line.depthStep;
    const std::ptrdiff_t size = piece.size;
    std::int64_t row = piece.row;
    for (std::ptrdiff_t i = 0; i < size; ++i) {
        tile.cover(i, row >> 32, SampleTile::key(depth, id));
        row += rowStep;
        depth += depthStep;
    }
}

/// The second samples: in the columns c where (c + 1) doubled / 2^32 passes a whole number.
void walkDoubled(Offsets tile, const LinePiece& piece, std::int64_t depth, const Line& line,
                 std::uint32_t id) {
    const std::uint64_t share = line.doubled;
    if (share == 0) return;
    const auto first = static_cast<std::uint64_t>(piece.first);
    const auto size = static_cast<std::uint64_t>(piece.size);
    for (std::uint64_t whole = (first * share >> 32U) + 1;; ++whole) {
        const std::uint64_t column = ((whole << 32U) - 1) / share - first;
        if (column >= size) return;
        const auto i = static_cast<std::int64_t>(column);
        const std::int64_t row = piece.row + line.rowStep * i;
        const bool nearNext = (row & (std::int64_t{1} << 31)) != 0;
        tile.cover(i, (row >> 32) + (nearNext ? 1 : -1),
                   SampleTile::key(depth + line.depthStep * i, id));
    }
}

}  // namespace

Line lineBetween(const ScreenPoint& a, const ScreenPoint& b, const Projection& projection,
                 const TileGrid& grid) {
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
    line.doubled = static_cast<std::uint32_t>((std::sqrt(1 + slope * slope) - 1) * one);

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

    // From one row before the tile to one after it: their second samples may lie in it.
    constexpr std::int64_t fixedOne = std::int64_t{1} << 32;
    piece.row -= across * fixedOne;
    clip(piece, line.rowStep, -fixedOne, (tile.size() + 1) * fixedOne);
    if (piece.size <= 0) return;

    const std::int64_t depth = line.depth + line.depthStep * (piece.first - line.first);
    const int column = piece.first - origin;
    const Offsets offsets = {tile.keys(), (line.alongY ? tile.rows() : tile.columns()) + column,
                             line.alongY ? tile.columns() : tile.rows()};
    walk(offsets, piece, depth, line, id);
    walkDoubled(offsets, piece, depth, line, id);
}

}  // namespace kushi
