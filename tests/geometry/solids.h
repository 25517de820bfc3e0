// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <kushi/distance_field.h>
#include <kushi/ellipsoid.h>

#include <array>
#include <cmath>
#include <cstdint>
#include <utility>

namespace kushi::test {

inline Mesh sphere(Vec3d center, double radius, int rows = 48) {
    return ellipsoidMesh({center, {radius, radius, radius}, 0}, rows);
}

/// A sphere pulled apart along y: half `length` each way.
inline Mesh capsule(double radius, double length, int rows = 48) {
    Mesh mesh = sphere({}, radius, rows);
    for (Vec3f& vertex : mesh.vertices)
        vertex.y += static_cast<float>(vertex.y > 0 ? 0.5 * length : -0.5 * length);
    return mesh;
}

inline Mesh box(Vec3f half) {
    Mesh mesh;
    for (int i = 0; i < 8; ++i) {
        mesh.vertices.push_back({(i & 1) != 0 ? half.x : -half.x, (i & 2) != 0 ? half.y : -half.y,
                                 (i & 4) != 0 ? half.z : -half.z});
    }
    mesh.triangles = {{0, 4, 6}, {0, 6, 2}, {1, 3, 7}, {1, 7, 5}, {0, 1, 5}, {0, 5, 4},
                      {2, 6, 7}, {2, 7, 3}, {0, 2, 3}, {0, 3, 1}, {4, 5, 7}, {4, 7, 6}};
    return mesh;
}

inline void append(Mesh& mesh, const Mesh& other) {
    const auto first = static_cast<std::uint32_t>(mesh.vertices.size());
    mesh.vertices.insert(mesh.vertices.end(), other.vertices.begin(), other.vertices.end());
    for (const auto& [a, b, c] : other.triangles)
        mesh.triangles.push_back({a + first, b + first, c + first});
}

inline void turn(std::array<std::uint32_t, 3>& triangle) {
    std::swap(triangle[1], triangle[2]);
}

}  // namespace kushi::test
