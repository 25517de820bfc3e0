// SPDX-License-Identifier: Apache-2.0
#include "io/place_mesh.h"

#include <kushi/head.h>

#include <algorithm>
#include <array>
#include <cstdio>
#include <limits>
#include <string_view>
#include <utility>

namespace kushi {
namespace {

// A tall person with the arms up [m].
constexpr double mostHeight = 2.5;
constexpr double mostWidth = 10;
// What lies in the 12 cm below the crown: the skull from the brows up, neither nose nor neck [m].
constexpr double skullHeight = 0.12;
// Its middle from front to back on the mannequin [m].
constexpr double skullMiddle = -0.007;

struct Extent {
    Vec3d low, high;
    bool any = false;

    void include(Vec3d p) {
        low = any ? Vec3d{std::min(low.x, p.x), std::min(low.y, p.y), std::min(low.z, p.z)} : p;
        high = any ? Vec3d{std::max(high.x, p.x), std::max(high.y, p.y), std::max(high.z, p.z)} : p;
        any = true;
    }
};

/// Of what lies above a height. Points on no triangle do not count.
Extent extentAbove(const Faces& faces, double height) {
    Extent extent;
    for (const Faces::Triangle& triangle : faces.triangles) {
        for (const Faces::Corner corner : triangle) {
            const Vec3d point = faces.points[corner.point];
            if (point.y >= height) extent.include(point);
        }
    }
    return extent;
}

std::string printed(const char* format, double value) {
    std::array<char, 64> text{};
    std::snprintf(text.data(), text.size(), format, value);
    return text.data();
}

/// The units in which a mesh would be of a plausible height, by its height in units.
std::string unitHint(double height, double leastHeight) {
    using Unit = std::pair<const char*, double>;
    std::string hint;
    for (const auto& [name, size] : {Unit{"m", 1}, {"cm", 0.01}, {"mm", 0.001}, {"in", 0.0254}}) {
        if (height * size < leastHeight || height * size > mostHeight) continue;
        hint += (hint.empty() ? "unit = \"" : ", unit = \"") + std::string(name) + "\" makes it " +
                printed("%.4g", 100 * height * size);
    }
    if (hint.empty()) hint = printed("unit = %.4g makes it 25", 25 / height);
    return hint;
}

std::string checkSize(Vec3d size, double unit, double leastHeight) {
    const double height = size.y;
    if (std::max(size.x, size.z) > mostWidth) {
        return "the mesh is " + printed("%.4g", 100 * std::max(size.x, size.z)) +
               " cm wide, expected 1000 at most";
    }
    if (height >= leastHeight && height <= mostHeight) return {};
    if (!(height > 0)) return "the mesh is flat: it has no height, expected a head";
    return "the mesh is " + printed("%.4g", 100 * height) + " cm high, expected " +
           printed("%g", 100 * leastHeight) + " to 250 (a head, or a whole figure); " +
           unitHint(height / unit, leastHeight);
}

}  // namespace

std::string placeMesh(Faces& faces, const MeshPlacement& placement, double unit) {
    unit = placement.unit.value_or(unit);
    const Vec3d right = cross(placement.front, placement.up);
    const auto turned = [&](Vec3d v) {
        return Vec3d{dot(v, placement.front), dot(v, placement.up), dot(v, right)};
    };
    for (Vec3d& point : faces.points)
        point = unit * turned(point);
    for (Vec3d& normal : faces.normals)
        normal = turned(normal);

    const Extent all = extentAbove(faces, -std::numeric_limits<double>::infinity());
    if (std::string fault = checkSize(all.high - all.low, unit, placement.leastHeight);
        !fault.empty())
        return fault;

    Vec3d shift = placement.offset;
    if (placement.origin == MeshOrigin::Crown) {
        const Extent skull = extentAbove(faces, all.high.y - skullHeight);
        shift += {skullMiddle - (skull.low.x + skull.high.x) / 2,
                  *landmarkHeight("crown") - all.high.y, -(skull.low.z + skull.high.z) / 2};
    }
    for (Vec3d& point : faces.points)
        point += shift;
    return {};
}

}  // namespace kushi
