// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <kushi/distance_field.h>

#include <algorithm>
#include <array>

namespace kushi {

/// A distance field at a place, smoothed so that its gradient has no jumps.
template <class T>
struct BasicFieldProbe {
    T distance = 0;               ///< m, < 0 inside
    std::array<T, 3> gradient{};  ///< nearly unit near a surface
    std::array<T, 6> hessian{};   ///< xx, yy, zz, xy, yz, zx [1/m]
};
using FieldProbe = BasicFieldProbe<float>;

/// The samples around a place, weighted by quadratic B-splines. They smooth: a surface of curvature
/// k (1/m, the sum of both) lies k spacing^2 / 8 deeper than it is.
///
/// place  at least two spacings from the border of the grid; nearer, the field is 1 m away
FieldProbe probe(const DistanceField& field, Vec3f place);

/// The same in double: floats round a place by what a stiff spring feels.
BasicFieldProbe<double> probe(const DistanceField& field, Vec3d place);

/// Distance at the sample next to a place, about a spacing from what it is at the place; 1 m
/// outside of the grid.
inline float roughDistance(const DistanceField& field, Vec3f place) {
    const float scale = 1 / field.spacing;
    const float x = (place.x - field.origin.x) * scale + 0.5F;
    const float y = (place.y - field.origin.y) * scale + 0.5F;
    const float z = (place.z - field.origin.z) * scale + 0.5F;
    const bool within = x >= 0 && y >= 0 && z >= 0 && x < static_cast<float>(field.size[0]) &&
                        y < static_cast<float>(field.size[1]) &&
                        z < static_cast<float>(field.size[2]);
    if (!within) return 1;
    const std::size_t at =
        field.index(static_cast<int>(x), static_cast<int>(y), static_cast<int>(z));
    return static_cast<float>(field.units[at]) * field.unit();
}

/// Which solid is nearest, by the sample next to a place; the first outside of the grid.
inline std::size_t nearestSolid(const DistanceField& field, Vec3f place) {
    if (field.nearest.empty()) return 0;
    const auto at = [&](float way, std::size_t axis) {
        const auto last = static_cast<float>(field.size[axis] - 1);
        // In this order, what is no number becomes 0.
        return static_cast<int>(std::min(std::max(0.0F, way / field.spacing + 0.5F), last));
    };
    const Vec3f way = place - field.origin;
    return field.nearest[field.index(at(way.x, 0), at(way.y, 1), at(way.z, 2))];
}

}  // namespace kushi
