// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <kushi/color.h>
#include <kushi/ellipsoid.h>

#include <array>
#include <cstdint>
#include <string>
#include <vector>

namespace kushi {

/// A place in a texture: 0 to 1 from left to right and from bottom to top; it repeats beyond.
struct TexturePoint {
    float u = 0, v = 0;

    friend bool operator==(const TexturePoint&, const TexturePoint&) = default;
};

/// Triangles, counter-clockwise seen from outside.
struct Mesh {
    std::vector<Vec3f> vertices;                          ///< m
    std::vector<Vec3f> normals;                           ///< unit, one per vertex
    std::vector<std::array<std::uint32_t, 3>> triangles;  ///< indices of vertices
    std::vector<Rgb> colors;                              ///< linear, one per vertex, or empty

    /// Of each triangle's corners, or empty; not a number where the file has none.
    std::vector<std::array<TexturePoint, 3>> uvs;
    /// Of each triangle: index of groupNames; or empty.
    std::vector<std::uint16_t> groups;
    /// What the triangles of a group go by: their object, groups and material; may be several.
    std::vector<std::vector<std::string>> groupNames;
};

/// Normals from the triangles around each vertex, weighted by area.
void computeNormals(Mesh& mesh);

/// The ellipsoid as triangles: `rows` bands along theta and twice as many along phi.
Mesh ellipsoidMesh(const Ellipsoid& ellipsoid, int rows);

}  // namespace kushi
