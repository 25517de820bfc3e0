// SPDX-License-Identifier: Apache-2.0
#include "render/area.h"

#include <algorithm>
#include <cmath>
#include <utility>

namespace kushi {

void AreaCoverage::addEdge(PixelPoint from, PixelPoint to) {
    float sign = 1;
    if (from.y > to.y) {
        std::swap(from, to);
        sign = -1;
    }
    const double limit = size_;
    if (!(from.y < to.y) || to.y <= 0 || from.y >= limit) return;
    const double slope = (to.x - from.x) / (to.y - from.y);
    const auto cut = [&](double y) { return PixelPoint{from.x + (y - from.y) * slope, y}; };
    PixelPoint a = from.y < 0 ? cut(0) : from;
    const PixelPoint b = to.y > limit ? cut(limit) : to;

    // In pieces that each lie on one side of the tile's edges: what is to its left counts as if it
    // were on its edge, what is to its right not at all but for its rows.
    double stops[3] = {b.y, b.y, b.y};
    std::size_t count = 0;
    for (const double x : {0.0, limit}) {
        if ((a.x < x) == (b.x < x)) continue;
        stops[count++] = std::clamp(from.y + (x - from.x) / slope, a.y, b.y);
    }
    if (count == 2 && stops[1] < stops[0]) std::swap(stops[0], stops[1]);
    const auto inTile = [limit](PixelPoint p) {
        return PixelPoint{std::clamp(p.x, 0.0, limit), p.y};
    };
    for (std::size_t i = 0; i <= count; ++i) {
        const PixelPoint end = i < count ? cut(stops[i]) : b;
        addClipped(inTile(a), inTile(end), sign);
        a = end;
    }
}

void AreaCoverage::addClipped(PixelPoint from, PixelPoint to, float sign) {
    if (!(from.y < to.y)) return;
    const double slope = (to.x - from.x) / (to.y - from.y);
    const int first = std::min(static_cast<int>(from.y), size_ - 1);
    const int last = std::min(static_cast<int>(std::ceil(to.y)), size_) - 1;
    top_ = std::min(top_, first);
    bottom_ = std::max(bottom_, last);
    double y = from.y;
    double x = from.x;
    for (int row = first; row <= last; ++row) {
        const double nextY = row < last ? row + 1.0 : to.y;
        const double nextX = row < last ? from.x + (nextY - from.y) * slope : to.x;
        addToRow(row, sign * (nextY - y), std::min(x, nextX), std::max(x, nextX));
        y = nextY;
        x = nextX;
    }
}

/// An edge within a row of pixels, from x = from to x = to >= from.
///
/// height  of the edge, with its sign
void AreaCoverage::addToRow(int y, double height, double from, double to) {
    Row& row = rows_[static_cast<std::size_t>(y)];
    float* changes = changes_.data() + static_cast<std::size_t>(y) * stride();
    const int first = static_cast<int>(from);
    const int last = std::max(static_cast<int>(std::ceil(to)) - 1, first);
    row.left = std::min(row.left, first);
    row.right = std::max(row.right, last + 1);
    if (first == last) {
        // A trapezium: of this pixel as much as lies right of the edge's middle.
        const double here = height * (first + 1 - 0.5 * (from + to));
        changes[first] += static_cast<float>(here);
        changes[first + 1] += static_cast<float>(height - here);
        return;
    }
    // Per pixel the edge gains this height; what it has gained before lies wholly to its right.
    const double gain = height / (to - from);
    double before = 0;
    for (int x = first; x <= last; ++x) {
        const double enter = std::max<double>(from, x);
        const double leave = std::min<double>(to, x + 1.0);
        const double gained = gain * (leave - enter);
        const double area = gained * (x + 1 - 0.5 * (enter + leave));
        changes[x] += static_cast<float>(area + before);
        before = gained - area;
    }
    changes[last + 1] += static_cast<float>(before);
}

}  // namespace kushi
