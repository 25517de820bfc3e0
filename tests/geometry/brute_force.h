// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <kushi/mesh.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>

// Distance and side of a place by looking at every triangle, in double and by other formulas than
// the library's.
namespace kushi::test {

/// To a segment from a to b.
inline double distanceToSegment(Vec3d p, Vec3d a, Vec3d b) {
    const Vec3d ab = b - a;
    const double t = std::clamp(dot(p - a, ab) / dot(ab, ab), 0.0, 1.0);
    return length(p - (a + t * ab));
}

/// To a triangle: to its plane where the perpendicular meets it, else to its sides.
inline double distanceToTriangle(Vec3d p, Vec3d a, Vec3d b, Vec3d c) {
    const Vec3d across = cross(b - a, c - a);
    const auto within = [&](Vec3d from, Vec3d to) {
        return dot(cross(to - from, p - from), across) >= 0;
    };
    if (length(across) > 0 && within(a, b) && within(b, c) && within(c, a)) {
        return std::abs(dot(p - a, across)) / length(across);
    }
    return std::min(
        {distanceToSegment(p, a, b), distanceToSegment(p, b, c), distanceToSegment(p, c, a)});
}

inline double distanceToMesh(const Mesh& mesh, Vec3d p) {
    double least = std::numeric_limits<double>::infinity();
    for (const auto& [a, b, c] : mesh.triangles) {
        least = std::min(least, distanceToTriangle(p, mesh.vertices[a].as<double>(),
                                                   mesh.vertices[b].as<double>(),
                                                   mesh.vertices[c].as<double>()));
    }
    return least;
}

/// How often a mesh winds around a place: the triangles' spherical excesses, by their angles.
inline double windingOfMesh(const Mesh& mesh, Vec3d p) {
    double sum = 0;
    for (const auto& [a, b, c] : mesh.triangles) {
        const Vec3d u = normalized(mesh.vertices[a].as<double>() - p);
        const Vec3d v = normalized(mesh.vertices[b].as<double>() - p);
        const Vec3d w = normalized(mesh.vertices[c].as<double>() - p);
        // L'Huilier's theorem, from the sides of the spherical triangle.
        const auto arc = [](Vec3d from, Vec3d to) {
            return 2 * std::asin(std::min(1.0, 0.5 * length(from - to)));
        };
        const double x = arc(u, v), y = arc(v, w), z = arc(w, u), s = 0.5 * (x + y + z);
        const double product = std::tan(0.5 * s) * std::tan(0.5 * (s - x)) *
                               std::tan(0.5 * (s - y)) * std::tan(0.5 * (s - z));
        const double excess = 4 * std::atan(std::sqrt(std::max(0.0, product)));
        sum += dot(u, cross(v, w)) >= 0 ? excess : -excess;
    }
    return sum / (4 * std::numbers::pi);
}

}  // namespace kushi::test
