// SPDX-License-Identifier: Apache-2.0
#include "geometry/skin.h"

#include "core/parallel.h"

#include <algorithm>
#include <array>
#include <cstdint>

namespace kushi {
namespace {

/// Whether both sides of a triangle are inside, just off its middle and its corners.
bool isHidden(const TriangleTree& surface, const Triangle& triangle) {
    const Vec3d a = triangle[0].as<double>(), b = triangle[1].as<double>(),
                c = triangle[2].as<double>();
    const Vec3d across = cross(b - a, c - a);
    // A thousandth of its size; the scale of `across` is the square of that of the triangle.
    const double size = std::sqrt(length(across));
    const Vec3d off = size > 0 ? (0.001 / size) * across : Vec3d{};
    const Vec3d middle = (a + b + c) / 3.0;
    const auto inside = [&](Vec3d place) { return windingNumber(surface, place) > 0.5; };
    const std::array<Vec3d, 4> places = {middle, a, b, c};
    return std::ranges::all_of(places, [&](Vec3d at) {
        const Vec3d place = middle + 0.9 * (at - middle);
        return inside(place + off) && inside(place - off);
    });
}

}  // namespace

std::vector<Triangle> skinOf(const TriangleTree& surface, int threads) {
    const std::vector<Triangle>& triangles = surface.triangles;
    std::vector<std::uint8_t> hidden(triangles.size());
    parallelFor(triangles.size(), 256, threads, [&](std::size_t begin, std::size_t end) {
        for (std::size_t i = begin; i < end; ++i)
            hidden[i] = isHidden(surface, triangles[i]) ? 1 : 0;
    });
    std::vector<Triangle> skin;
    for (std::size_t i = 0; i < triangles.size(); ++i) {
        if (hidden[i] == 0) skin.push_back(triangles[i]);
    }
    return skin;
}

}  // namespace kushi
