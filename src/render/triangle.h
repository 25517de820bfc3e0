// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "render/scene.h"
#include "render/tile.h"

#include <array>
#include <cstdint>

namespace kushi {

/// Draws a polygon's triangles, from either side: the samples whose centre lies inside. Triangles
/// that share an edge share no sample and leave none out.
void drawPolygon(SampleTile& tile, const ScreenPolygon& polygon, const Projection& projection,
                 std::uint32_t id);

/// The picture's columns and rows of tiles that a polygon may touch: [left, right) x [top, bottom).
struct TileBox {
    int left = 0, top = 0, right = 0, bottom = 0;
};
TileBox tilesOf(const ScreenPolygon& polygon, const TileGrid& grid);

/// A value given at three points, as a function of place: value(a) at a, linear in between.
struct Gradient {
    double perX = 0, perY = 0;
};

/// The gradients of any value over the triangle a, b, c; zero where it is too thin to tell.
class Plane {
public:
    Plane(const ScreenPoint& a, const ScreenPoint& b, const ScreenPoint& c);
    Gradient gradient(double atA, double atB, double atC) const;

private:
    double abX_, abY_, acX_, acY_, inverseArea_;
};

}  // namespace kushi
