// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <kushi/head.h>

#include <functional>
#include <limits>
#include <optional>

// Measuring a head in centimetres.
namespace kushi {

inline const Mesh& theHead() {
    static const Mesh mesh = mannequin();
    return mesh;
}

inline Vec3d inCm(Vec3f vertex) {
    return 100.0 * vertex.as<double>();
}

/// The vertex among those that `counts` that lies farthest along `direction`.
inline Vec3d farthest(Vec3d direction, const std::function<bool(Vec3d)>& counts) {
    Vec3d best;
    double most = -std::numeric_limits<double>::infinity();
    for (const Vec3f vertex : theHead().vertices) {
        const Vec3d p = inCm(vertex);
        if (!counts(p) || dot(p, direction) <= most) continue;
        most = dot(p, direction);
        best = p;
    }
    return best;
}

/// Where a ray first meets the head (Moeller and Trumbore, 1997).
inline std::optional<Vec3d> firstHit(Vec3d origin, Vec3d direction) {
    double nearest = std::numeric_limits<double>::infinity();
    for (const auto& [ia, ib, ic] : theHead().triangles) {
        const Vec3d a = inCm(theHead().vertices[ia]);
        const Vec3d ab = inCm(theHead().vertices[ib]) - a;
        const Vec3d ac = inCm(theHead().vertices[ic]) - a;
        const Vec3d across = cross(direction, ac);
        const double determinant = dot(ab, across);
        if (determinant == 0) continue;
        const Vec3d from = origin - a;
        const double u = dot(from, across) / determinant;
        const Vec3d turned = cross(from, ab);
        const double v = dot(direction, turned) / determinant;
        const double t = dot(ac, turned) / determinant;
        if (u >= 0 && v >= 0 && u + v <= 1 && t > 0 && t < nearest) nearest = t;
    }
    if (nearest == std::numeric_limits<double>::infinity()) return std::nullopt;
    return origin + nearest * direction;
}

}  // namespace kushi
