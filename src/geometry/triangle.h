// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <kushi/vec.h>

#include <algorithm>
#include <array>

namespace kushi {

/// The corners of a triangle, counter-clockwise seen from outside.
using Triangle = std::array<Vec3f, 3>;

inline Vec3f closestOnSegment(Vec3f place, Vec3f a, Vec3f b) {
    const Vec3f along = b - a;
    const float square = dot(along, along);
    return square > 0 ? a + std::clamp(dot(place - a, along) / square, 0.0F, 1.0F) * along : a;
}

/// The point of a triangle that is nearest to a place (Ericson, Real-Time Collision Detection,
/// 5.1.5). The triangle may be a segment or a point.
inline Vec3f closestOnTriangle(Vec3f place, const Triangle& triangle) {
    const auto& [a, b, c] = triangle;
    const Vec3f ab = b - a, ac = c - a;
    const Vec3f fromA = place - a, fromB = place - b, fromC = place - c;
    const float abA = dot(ab, fromA), acA = dot(ac, fromA);
    if (abA <= 0 && acA <= 0) return a;
    const float abB = dot(ab, fromB), acB = dot(ac, fromB);
    if (abB >= 0 && acB <= abB) return b;
    const float abC = dot(ab, fromC), acC = dot(ac, fromC);
    if (acC >= 0 && abC <= acC) return c;

    // Twice the area times the barycentric coordinates of the foot of the perpendicular.
    const float atC = abA * acB - abB * acA;
    if (atC <= 0 && abA >= 0 && abB <= 0) return closestOnSegment(place, a, b);
    const float atB = abC * acA - abA * acC;
    if (atB <= 0 && acA >= 0 && acC <= 0) return closestOnSegment(place, a, c);
    const float atA = abB * acC - abC * acB;
    if (atA <= 0 && acB >= abB && abC >= acC) return closestOnSegment(place, b, c);
    const float sum = atA + atB + atC;
    return sum > 0 ? a + (atB / sum) * ab + (atC / sum) * ac : a;
}

/// The solid angle that a triangle takes up seen from a place, above 0 from behind (Van Oosterom
/// and Strackee 1983).
inline double solidAngle(Vec3d place, const Triangle& triangle) {
    const Vec3d a = triangle[0].as<double>() - place;
    const Vec3d b = triangle[1].as<double>() - place;
    const Vec3d c = triangle[2].as<double>() - place;
    const double sizeA = length(a), sizeB = length(b), sizeC = length(c);
    const double volume = dot(a, cross(b, c));
    const double rest =
        sizeA * sizeB * sizeC + dot(a, b) * sizeC + dot(b, c) * sizeA + dot(c, a) * sizeB;
    return 2 * std::atan2(volume, rest);
}

}  // namespace kushi
