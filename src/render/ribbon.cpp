// SPDX-License-Identifier: Apache-2.0
#include "render/ribbon.h"

#include "render/edge.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <optional>
#include <utility>

namespace kushi {

namespace {

struct Direction {
    double x = 0, y = 0;
};

/// The direction of a segment on the picture; none if it is seen along its axis.
std::optional<Direction> directionOf(const ScreenSegment& segment) {
    const double x = segment.b.x - segment.a.x;
    const double y = segment.b.y - segment.a.y;
    const double size = std::sqrt(x * x + y * y);
    if (!(size > 1e-6)) return std::nullopt;
    return Direction{x / size, y / size};
}

std::optional<Direction> directionFrom(const Scene& scene, std::uint32_t node) {
    const std::optional<ScreenSegment> segment = scene.segment(node);
    return segment ? directionOf(*segment) : std::nullopt;
}

/// From a node to its corner, for a strand two wide: on the line that halves the angle between the
/// segments that meet there.
Direction mitre(Direction one, std::optional<Direction> other) {
    const Direction along = other.value_or(one);
    const double cosine = one.x * along.x + one.y * along.y;
    if (cosine < 0) return {-one.y, one.x};
    return {-(one.y + along.y) / (1 + cosine), (one.x + along.x) / (1 + cosine)};
}

/// Where the samples of each row of a tile begin and end.
class RowRanges {
public:
    RowRanges(int firstRow, int rows) : firstRow_(firstRow), rows_(rows) {}

    /// Widens the rows whose centre the edge passes to where it does.
    void include(const Edge& edge) {
        const auto inTile = [&](double y) {
            return std::clamp(ceilToInt(y - firstRow_ - 0.5), 0, rows_);
        };
        const int begin = inTile(edge.top.y);
        const int end = inTile(edge.bottom.y);
        for (int row = begin; row < end; ++row) {
            const double x = edge.at(firstRow_ + row + 0.5);
            auto& [left, right] = ranges_[static_cast<std::size_t>(row)];
            left = std::min(left, x);
            right = std::max(right, x);
        }
        begin_ = std::min(begin_, begin);
        end_ = std::max(end_, end);
    }

    int begin() const { return begin_; }
    int end() const { return end_; }
    std::pair<double, double> operator[](int row) const {
        return ranges_[static_cast<std::size_t>(row)];
    }
    void wipe(int begin, int end) {
        std::fill(ranges_.begin() + begin, ranges_.begin() + end, nothing);
    }

private:
    static constexpr std::size_t most = 256;  // the side of the largest tile
    static constexpr std::pair nothing = {1e30, -1e30};

    int firstRow_, rows_;
    int begin_ = most, end_ = 0;
    std::array<std::pair<double, double>, most> ranges_;
};

}  // namespace

ScreenPolygon ribbonOf(const Scene& scene, std::uint32_t node, const ScreenSegment& segment) {
    const std::optional<Direction> direction = directionOf(segment);
    if (!direction) return {};
    const bool startsHere = segment.from > 0 || scene.beginsStrand(node);
    const bool endsHere = segment.to < 1 || scene.endsStrand(node + 1);
    const Direction first =
        mitre(*direction, startsHere ? std::nullopt : directionFrom(scene, node - 1));
    const Direction last =
        mitre(*direction, endsHere ? std::nullopt : directionFrom(scene, node + 1));

    const auto corner = [](const ScreenPoint& at, Direction side, double sign) {
        const double half = sign * 0.5 * at.width;
        return ScreenPolygon::Corner{{at.x + half * side.x, at.y + half * side.y, at.q}, {}};
    };
    return {{corner(segment.a, first, -1), corner(segment.a, first, 1), corner(segment.b, last, 1),
             corner(segment.b, last, -1)},
            4};
}

void drawRibbon(SampleTile& tile, const ScreenPolygon& ribbon, const ScreenSegment& segment,
                const Projection& projection, std::uint32_t id) {
    if (ribbon.size != 4) return;
    const auto& corners = ribbon.corners;
    const auto [top, bottom] =
        std::minmax({corners[0].at.y, corners[1].at.y, corners[2].at.y, corners[3].at.y});
    const auto rowOf = [&](double y) {
        return std::clamp(ceilToInt(y - tile.y() - 0.5), 0, tile.size());
    };
    RowRanges ranges(tile.y(), tile.size());
    ranges.wipe(rowOf(top), rowOf(bottom));
    for (std::size_t i = 0; i < 4; ++i)
        ranges.include(Edge(corners[i].at, corners[(i + 1) % 4].at));

    // Depth runs from one node to the other, and is the same across.
    const double depthA = drawableDepth(projection.depth(segment.a.q));
    const double depthB = drawableDepth(projection.depth(segment.b.q));
    const auto [low, high] = std::minmax(depthA, depthB);
    const double x = segment.b.x - segment.a.x;
    const double y = segment.b.y - segment.a.y;
    const double perLength = (depthB - depthA) / (x * x + y * y);
    const double perX = x * perLength;
    const double perY = y * perLength;
    const double start =
        depthA + perX * (tile.x() + 0.5 - segment.a.x) + perY * (tile.y() + 0.5 - segment.a.y);
    for (int row = ranges.begin(); row < ranges.end(); ++row) {
        const auto [left, right] = ranges[row];
        const auto columnOf = [&](double at) {
            return ceilToInt(std::clamp<double>(at - tile.x() - 0.5, 0, tile.size()));
        };
        const int begin = columnOf(left);
        const int end = columnOf(right);
        SampleTile::Key* keys = tile.keys() + tile.rows()[row];
        const double inRow = start + perY * row;
        for (int column = begin; column < end; ++column) {
            const double depth = std::clamp(inRow + perX * column, low, high);
            SampleTile::Key& sample = keys[tile.columns()[column]];
            sample = std::min(sample, SampleTile::key(static_cast<std::int64_t>(depth), id));
        }
    }
}

}  // namespace kushi
