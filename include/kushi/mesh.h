// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <kushi/color.h>
#include <kushi/ellipsoid.h>

#include <array>
#include <cstdint>
#include <vector>

namespace kushi {

/// Triangles, counter-clockwise seen from outside.
struct Mesh {
    std::vector<Vec3f> vertices;                          ///< m
    std::vector<Vec3f> normals;                           ///< unit, one per vertex
    std::vector<std::array<std::uint32_t, 3>> triangles;  ///< indices of vertices
    std::vector<Rgb> colors;                              ///< linear, one per vertex, or empty
};

/// Normals from the triangles around each vertex, weighted by area.
void computeNormals(Mesh& mesh);

/// The ellipsoid as triangles: `rows` bands along theta and twice as many along phi.
Mesh ellipsoidMesh(const Ellipsoid& ellipsoid, int rows);

}  // namespace kushi
