// SPDX-License-Identifier: Apache-2.0
#include "rod/polyline_frames.h"

#include <algorithm>
#include <cmath>

namespace kushi {

namespace {

// Some unit vector normal to the unit vector t.
Vec3d anyNormal(Vec3d t) {
    return normalized(cross(t, std::abs(t.x) < 0.7 ? Vec3d{1, 0, 0} : Vec3d{0, 1, 0}));
}

// Between the directions of two segments, that of the circle through their three nodes; normal to
// both where the second runs straight back.
Vec3d tangentBetween(Vec3d before, Vec3d after) {
    const double d0 = length(before);
    const double d1 = length(after);
    const Vec3d e0 = before / d0;
    const Vec3d e1 = after / d1;
    const Vec3d sum = d1 * e0 + d0 * e1;
    return length(sum) > 1e-6 * (d0 + d1) ? normalized(sum) : anyNormal(e0);
}

// `t` as seen from the other end of a segment along e: their mean is along e.
Vec3d mirrored(Vec3d t, Vec3d e) {
    return normalized(2 * dot(t, e) * e - t);
}

// The shortest rotation of one unit vector into another.
Rotation shortest(Vec3d from, Vec3d to) {
    const double w = 1 + dot(from, to);
    if (w < 1e-12) return {0, anyNormal(from)};
    return normalized(Rotation{w, cross(from, to)});
}

Vec3d noFurther(Vec3d from, Vec3d to) {
    const double angle = std::atan2(length(cross(from, to)), dot(from, to));
    if (angle <= sharpest) return to;
    const Rotation whole = shortest(from, to);
    const Vec3d axis = normalized(whole.v);
    return normalized(rotate({std::cos(0.5 * sharpest), std::sin(0.5 * sharpest) * axis}, from));
}

}  // namespace

Rotation operator*(const Rotation& a, const Rotation& b) {
    return {a.w * b.w - dot(a.v, b.v), a.w * b.v + b.w * a.v + cross(a.v, b.v)};
}

Rotation inverse(const Rotation& a) {
    return {a.w, -a.v};
}

Rotation normalized(const Rotation& a) {
    const double scale = 1 / std::sqrt(a.w * a.w + dot(a.v, a.v));
    return {a.w * scale, a.v * scale};
}

Rotation halfway(const Rotation& a, const Rotation& b) {
    return normalized(Rotation{a.w + b.w, a.v + b.v});
}

Vec3d rotate(const Rotation& by, Vec3d v) {
    const Vec3d t = 2 * cross(by.v, v);
    return v + by.w * t + cross(by.v, t);
}

std::vector<Vec3d> nodeTangents(std::span<const Vec3d> nodes) {
    const std::size_t last = nodes.size() - 1;
    std::vector<Vec3d> tangents(nodes.size());
    const auto segment = [&](std::size_t j) { return nodes[j + 1] - nodes[j]; };
    for (std::size_t j = 1; j < last; ++j)
        tangents[j] = tangentBetween(segment(j - 1), segment(j));
    const Vec3d first = normalized(segment(0));
    const Vec3d end = normalized(segment(last - 1));
    tangents[0] = last > 1 ? mirrored(tangents[1], first) : first;
    tangents[last] = last > 1 ? mirrored(tangents[last - 1], end) : end;
    for (std::size_t j = 1; j <= last; ++j)
        tangents[j] = noFurther(tangents[j - 1], tangents[j]);
    return tangents;
}

std::vector<Rotation> framesAlong(std::span<const Vec3d> tangents) {
    return framesAlong(tangents, rotationOf(frameAlong(tangents[0])));
}

std::vector<Rotation> framesAlong(std::span<const Vec3d> tangents, const Rotation& first) {
    std::vector<Rotation> frames(tangents.size());
    frames[0] = first;
    for (std::size_t j = 1; j < tangents.size(); ++j) {
        // From where d3 really is, so that no error of rounding adds up.
        const Vec3d from = rotate(frames[j - 1], {0, 0, 1});
        frames[j] = normalized(shortest(from, tangents[j]) * frames[j - 1]);
    }
    return frames;
}

Rotation rotationOf(const Frame& frame) {
    return normalized(Rotation{frame.w, Vec3f{frame.x, frame.y, frame.z}.as<double>()});
}

Frame frameOf(const Rotation& rotation) {
    const Vec3f v = rotation.v.as<float>();
    return {static_cast<float>(rotation.w), v.x, v.y, v.z};
}

}  // namespace kushi
