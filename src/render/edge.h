// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "render/projection.h"

#include <utility>

namespace kushi {

/// Where the edge between two points crosses the row centre y. Both triangles at an edge put the
/// same two points in, ordered the same, and so get the same.
struct Edge {
    ScreenPoint top, bottom;
    double slope = 0;  // means nothing where the edge is level and crosses no row

    Edge(const ScreenPoint& a, const ScreenPoint& b) : top(a), bottom(b) {
        if (std::pair(b.y, b.x) < std::pair(a.y, a.x)) std::swap(top, bottom);
        if (bottom.y > top.y) slope = (bottom.x - top.x) / (bottom.y - top.y);
    }
    bool crosses(double y) const { return top.y <= y && y < bottom.y; }
    double at(double y) const { return top.x + (y - top.y) * slope; }
};

}  // namespace kushi
