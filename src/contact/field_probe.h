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

/// Outward of the nearest surface, unit; +y where that is undecided.
Vec3d outwardAt(const DistanceField& field, Vec3d place);

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
