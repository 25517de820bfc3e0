// SPDX-License-Identifier: Apache-2.0
#include "io/weld.h"

#include "core/random.h"

#include <algorithm>
#include <array>
#include <bit>
#include <limits>
#include <unordered_map>
#include <utility>

namespace kushi {
namespace {

struct Vertex {
    Vec3f point, normal;

    friend bool operator==(const Vertex&, const Vertex&) = default;
};

struct VertexHash {
    std::size_t operator()(const Vertex& vertex) const {
        std::uint64_t key = 0;
        for (const Vec3f v : {vertex.point, vertex.normal}) {
            for (const float number : {v.x, v.y, v.z})
                key = mixKey(key, std::bit_cast<std::uint32_t>(number));
        }
        return key;
    }
};

// 0 and -0 are equal, but not their bits.
Vec3f rounded(Vec3d v) {
    return v.as<float>() + Vec3f{0, 0, 0};
}

bool isDirection(Vec3d v) {
    const double size = length(v);
    return size > 1e-30 && size < 1e30;
}

bool haveNormals(const Faces& faces) {
    return std::ranges::all_of(faces.triangles, [&](const Faces::Triangle& triangle) {
        return std::ranges::all_of(triangle, [&](Faces::Corner corner) {
            return corner.normal != Faces::none && isDirection(faces.normals[corner.normal]);
        });
    });
}

std::array<TexturePoint, 3> uvsOf(const Faces& faces, const Faces::Triangle& triangle) {
    constexpr float unknown = std::numeric_limits<float>::quiet_NaN();
    std::array<TexturePoint, 3> uvs;
    std::ranges::transform(triangle, uvs.begin(), [&](Faces::Corner corner) {
        return corner.uv == Faces::none ? TexturePoint{unknown, unknown} : faces.uvs[corner.uv];
    });
    return uvs;
}

Mesh joined(const Faces& faces, bool withNormals) {
    Mesh mesh;
    std::unordered_map<Vertex, std::uint32_t, VertexHash> known;
    known.reserve(faces.points.size());
    const auto indexOf = [&](Faces::Corner corner) {
        Vertex vertex = {rounded(faces.points[corner.point]), {}};
        if (withNormals) vertex.normal = rounded(normalized(faces.normals[corner.normal]));
        const auto next = static_cast<std::uint32_t>(mesh.vertices.size());
        const auto [entry, isNew] = known.emplace(vertex, next);
        if (isNew) {
            mesh.vertices.push_back(vertex.point);
            if (withNormals) mesh.normals.push_back(vertex.normal);
        }
        return entry->second;
    };
    mesh.triangles.reserve(faces.triangles.size());
    mesh.groupNames = faces.groupNames;
    for (std::size_t i = 0; i < faces.triangles.size(); ++i) {
        const auto& [a, b, c] = faces.triangles[i];
        const Vec3f pointA = rounded(faces.points[a.point]);
        const Vec3f edgeB = rounded(faces.points[b.point]) - pointA;
        const Vec3f edgeC = rounded(faces.points[c.point]) - pointA;
        if (cross(edgeB, edgeC) == Vec3f{}) continue;
        const std::uint32_t first = indexOf(a), second = indexOf(b);
        mesh.triangles.push_back({first, second, indexOf(c)});
        if (!faces.uvs.empty()) mesh.uvs.push_back(uvsOf(faces, faces.triangles[i]));
        if (!faces.groups.empty()) mesh.groups.push_back(faces.groups[i]);
    }
    return mesh;
}

/// Twice the area of a triangle, along its normal.
Vec3d twiceArea(const Mesh& mesh, const std::array<std::uint32_t, 3>& triangle) {
    const auto at = [&](std::size_t i) { return mesh.vertices[triangle[i]].as<double>(); };
    return cross(at(1) - at(0), at(2) - at(0));
}

// By the volume about the mean of the vertices, which a hole such as a neck hardly changes.
bool isInsideOut(const Mesh& mesh) {
    Vec3d middle;
    for (const Vec3f vertex : mesh.vertices)
        middle += vertex.as<double>() / static_cast<double>(mesh.vertices.size());
    double volume = 0;
    for (const auto& triangle : mesh.triangles) {
        volume += dot(mesh.vertices[triangle[0]].as<double>() - middle, twiceArea(mesh, triangle));
    }
    return volume < 0;
}

// By the triangles, which are turned outwards already.
bool pointInwards(const Mesh& mesh) {
    double agreement = 0;
    for (const auto& triangle : mesh.triangles) {
        for (const std::uint32_t corner : triangle)
            agreement += dot(mesh.normals[corner].as<double>(), twiceArea(mesh, triangle));
    }
    return agreement < 0;
}

}  // namespace

Mesh weld(const Faces& faces) {
    const bool withNormals = haveNormals(faces);
    Mesh mesh = joined(faces, withNormals);
    if (isInsideOut(mesh)) {
        for (auto& triangle : mesh.triangles)
            std::swap(triangle[1], triangle[2]);
        for (auto& corners : mesh.uvs)
            std::swap(corners[1], corners[2]);
    }
    if (!withNormals) {
        computeNormals(mesh);
    } else if (pointInwards(mesh)) {
        for (Vec3f& normal : mesh.normals)
            normal = -normal;
    }
    return mesh;
}

}  // namespace kushi
