// SPDX-License-Identifier: Apache-2.0
//
// Distance fields of shapes with a closed form.
#pragma once

#include <kushi/distance_field.h>

#include <algorithm>
#include <cmath>

namespace kushi::rest {

// distance  of a place, a function of Vec3d
template <class Distance>
DistanceField sampled(Vec3d low, Vec3d high, double spacing, const Distance& distance) {
    DistanceField field;
    field.origin = low.as<float>();
    field.spacing = static_cast<float>(spacing);
    const Vec3d extent = high - low;
    const double sizes[] = {extent.x, extent.y, extent.z};
    for (std::size_t axis = 0; axis < 3; ++axis)
        field.size[axis] = static_cast<int>(std::ceil(sizes[axis] / spacing)) + 1;
    field.units.reserve(field.index(0, 0, field.size[2]));
    for (int z = 0; z < field.size[2]; ++z) {
        for (int y = 0; y < field.size[1]; ++y) {
            for (int x = 0; x < field.size[0]; ++x) {
                const Vec3d at = low + spacing * Vec3d{double(x), double(y), double(z)};
                const double units = distance(at) / static_cast<double>(field.unit());
                field.units.push_back(
                    static_cast<std::int16_t>(std::lround(std::clamp(units, -32767.0, 32767.0))));
            }
        }
    }
    return field;
}

inline double sphereDistance(Vec3d at, Vec3d center, double radius) {
    return length(at - center) - radius;
}

inline double capsuleDistance(Vec3d at, Vec3d from, Vec3d to, double radius) {
    const Vec3d way = to - from;
    const double share = std::clamp(dot(at - from, way) / dot(way, way), 0.0, 1.0);
    return length(at - (from + share * way)) - radius;
}

// A head of 9 cm, a neck and shoulders.
inline double bustDistance(Vec3d at) {
    return std::min({sphereDistance(at, {0, 0, 0}, 0.09),
                     capsuleDistance(at, {-0.01, -0.05, 0}, {-0.02, -0.25, 0}, 0.055),
                     capsuleDistance(at, {-0.03, -0.27, -0.15}, {-0.03, -0.27, 0.15}, 0.06),
                     capsuleDistance(at, {-0.03, -0.3, 0}, {-0.03, -0.6, 0}, 0.15)});
}

inline DistanceField bust() {
    return sampled({-0.25, -0.65, -0.3}, {0.2, 0.15, 0.3}, 0.0025, bustDistance);
}

}  // namespace kushi::rest
