// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <kushi/vec.h>

#include <array>
#include <cstdint>
#include <functional>
#include <vector>

namespace kushi {

/// A shape with z = 0 as its plane of symmetry: negative inside, roughly the distance to the
/// surface.
using Field = std::function<double(Vec3d)>;

/// Unit normal of the level set through p, by differences over +-h.
Vec3d fieldNormal(const Field& field, Vec3d p, double h);

/// p moved onto the surface along the gradient, `steps` Newton steps; stays at z = 0 if `onPlane`.
Vec3d ontoSurface(const Field& field, Vec3d p, bool onPlane, int steps);

/// Planes of a grid that is fine where the shape needs it.
struct Grid {
    std::vector<double> x, y;  ///< ascending
    std::vector<double> z;     ///< ascending from z[0] > 0; the first cell is [-z[0], z[0]]
};

/// Spacing wanted at a place on an axis; linear between places.
struct GridKey {
    double at = 0;
    double spacing = 0;
};

/// Planes from the first key to beyond the last.
std::vector<double> gradedPlanes(const std::vector<GridKey>& keys);

/// The half z >= 0 of a symmetric surface; its border lies on z = 0.
struct HalfSurface {
    std::vector<Vec3d> points;
    std::vector<std::uint8_t> onPlane;  ///< 1 where z = 0
    std::vector<std::array<std::uint32_t, 3>> triangles;
};

/// The surface field = 0 as the dual of the grid (Gibson, "Constrained elastic surface nets",
/// 1998), every vertex on the surface. It must lie strictly within the grid, its parts more than a
/// cell apart.
HalfSurface polygonise(const Field& field, const Grid& grid);

}  // namespace kushi
