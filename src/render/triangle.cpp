// SPDX-License-Identifier: Apache-2.0
#include "render/triangle.h"

#include "render/edge.h"

#include <cmath>
#include <limits>

namespace kushi {

namespace {

class Triangle {
public:
    Triangle(const ScreenPoint& a, const ScreenPoint& b, const ScreenPoint& c,
             const Projection& projection)
        : edges_{{{a, b}, {b, c}, {c, a}}}, corner_(a) {
        const double depthA = drawableDepth(projection.depth(a.q));
        const double depthB = drawableDepth(projection.depth(b.q));
        const double depthC = drawableDepth(projection.depth(c.q));
        low_ = std::min({depthA, depthB, depthC});
        high_ = std::max({depthA, depthB, depthC});
        cornerDepth_ = depthA;
        slope_ = Plane(a, b, c).gradient(depthA, depthB, depthC);
        top_ = std::min({a.y, b.y, c.y});
        bottom_ = std::max({a.y, b.y, c.y});
    }

    void draw(SampleTile& tile, std::uint32_t id) const {
        const auto inTile = [&](double row) {
            return std::clamp<double>(row, tile.y(), tile.y() + tile.size());
        };
        const int begin = ceilToInt(inTile(top_ - 0.5));
        const int end = ceilToInt(inTile(bottom_ - 0.5));
        for (int row = begin; row < end; ++row)
            drawRow(tile, row, id);
    }

private:
    /// Row centres in [top, bottom), column centres in [left, right).
    void drawRow(SampleTile& tile, int row, std::uint32_t id) const {
        const double y = row + 0.5;
        double left = std::numeric_limits<double>::infinity();
        double right = -left;
        for (const Edge& edge : edges_) {
            if (!edge.crosses(y)) continue;
            const double x = edge.at(y);
            left = std::min(left, x);
            right = std::max(right, x);
        }
        const auto inTile = [&](double column) {
            return std::clamp<double>(column, tile.x(), tile.x() + tile.size());
        };
        const int begin = ceilToInt(inTile(left - 0.5));
        const int end = ceilToInt(inTile(right - 0.5));
        if (begin < end) drawSpan(tile, row, begin, end, id);
    }

    void drawSpan(SampleTile& tile, int row, int begin, int end, std::uint32_t id) const {
        const double first = depthAt(begin, row);
        const double last = depthAt(end - 1, row);
        const double step = begin + 1 < end ? (last - first) / (end - 1 - begin) : 0;
        const auto depthStep = static_cast<std::int64_t>(step);
        auto depth = static_cast<std::int64_t>(first);
        SampleTile::Key* keys = tile.keys() + tile.rows()[row - tile.y()];
        const std::ptrdiff_t* columns = tile.columns() - tile.x();
        for (int i = begin; i < end; ++i) {
            SampleTile::Key& sample = keys[columns[i]];
            sample = std::min(sample, SampleTile::key(depth, id));
            depth += depthStep;
        }
    }

    double depthAt(int column, int row) const {
        const double depth = cornerDepth_ + slope_.perX * (column + 0.5 - corner_.x) +
                             slope_.perY * (row + 0.5 - corner_.y);
        return std::clamp(depth, low_, high_);
    }

    std::array<Edge, 3> edges_;
    ScreenPoint corner_;
    double cornerDepth_, low_, high_;
    Gradient slope_;
    double top_, bottom_;
};

}  // namespace

void drawPolygon(SampleTile& tile, const ScreenPolygon& polygon, const Projection& projection,
                 std::uint32_t id) {
    const auto& corners = polygon.corners;
    for (std::size_t i = 2; i < static_cast<std::size_t>(polygon.size); ++i) {
        Triangle(corners[0].at, corners[i - 1].at, corners[i].at, projection).draw(tile, id);
    }
}

TileBox tilesOf(const ScreenPolygon& polygon, const TileGrid& grid) {
    if (polygon.size == 0) return {};
    ScreenPoint low = polygon.corners[0].at;
    ScreenPoint high = low;
    for (int i = 1; i < polygon.size; ++i) {
        const ScreenPoint at = polygon.corners[static_cast<std::size_t>(i)].at;
        low = {std::min(low.x, at.x), std::min(low.y, at.y), 0};
        high = {std::max(high.x, at.x), std::max(high.y, at.y), 0};
    }
    const auto tile = [&](double x, int end) {
        return floorToInt(std::clamp(x / grid.tileSize(), 0.0, static_cast<double>(end)));
    };
    const auto tileAfter = [&](double x, int end) { return std::min(tile(x, end) + 1, end); };
    if (high.x < 0 || high.y < 0) return {};
    return {tile(low.x, grid.columns()), tile(low.y, grid.rows()),
            tileAfter(high.x, grid.columns()), tileAfter(high.y, grid.rows())};
}

Plane::Plane(const ScreenPoint& a, const ScreenPoint& b, const ScreenPoint& c)
    : abX_(b.x - a.x), abY_(b.y - a.y), acX_(c.x - a.x), acY_(c.y - a.y) {
    const double area = abX_ * acY_ - acX_ * abY_;
    inverseArea_ = std::abs(area) > 0.01 ? 1 / area : 0;
}

Gradient Plane::gradient(double atA, double atB, double atC) const {
    const double ab = atB - atA;
    const double ac = atC - atA;
    return {(ab * acY_ - ac * abY_) * inverseArea_, (ac * abX_ - ab * acX_) * inverseArea_};
}

}  // namespace kushi
