// SPDX-License-Identifier: Apache-2.0
#include <kushi/mesh.h>

namespace kushi {

void computeNormals(Mesh& mesh) {
    mesh.normals.assign(mesh.vertices.size(), Vec3f{});
    for (const auto& [a, b, c] : mesh.triangles) {
        const Vec3f origin = mesh.vertices[a];
        const Vec3f twiceArea = cross(mesh.vertices[b] - origin, mesh.vertices[c] - origin);
        for (const std::uint32_t corner : {a, b, c})
            mesh.normals[corner] += twiceArea;
    }
    for (Vec3f& normal : mesh.normals) {
        const float size = length(normal);
        normal = size > 0 ? normal / size : Vec3f{0, 1, 0};
    }
}

Mesh ellipsoidMesh(const Ellipsoid& ellipsoid, int rows) {
    const int columns = 2 * rows;
    Mesh mesh;
    const auto addVertex = [&](double theta, double phi) {
        const Vec3d point = ellipsoid.point({theta, phi});
        mesh.vertices.push_back(point.as<float>());
        mesh.normals.push_back(ellipsoid.normal(point).as<float>());
    };
    addVertex(0, 0);
    for (int row = 1; row < rows; ++row) {
        for (int column = 0; column < columns; ++column) {
            addVertex(std::numbers::pi * row / rows, 2 * std::numbers::pi * column / columns);
        }
    }
    addVertex(std::numbers::pi, 0);

    const auto south = static_cast<std::uint32_t>(mesh.vertices.size() - 1);
    const auto vertex = [&](int row, int column) {
        if (row == 0) return std::uint32_t{0};
        if (row == rows) return south;
        return static_cast<std::uint32_t>(1 + (row - 1) * columns + column % columns);
    };
    for (int row = 0; row < rows; ++row) {
        for (int column = 0; column < columns; ++column) {
            const std::uint32_t a = vertex(row, column);
            const std::uint32_t b = vertex(row, column + 1);
            const std::uint32_t c = vertex(row + 1, column);
            const std::uint32_t d = vertex(row + 1, column + 1);
            if (row > 0) mesh.triangles.push_back({a, b, d});
            if (row + 1 < rows) mesh.triangles.push_back({a, d, c});
        }
    }
    return mesh;
}

}  // namespace kushi
