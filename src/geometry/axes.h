// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <kushi/vec.h>

#include <cmath>

namespace kushi {

/// Some unit vector normal to the unit vector `n`.
inline Vec3f anyNormal(Vec3f n) {
    const Vec3f other = std::abs(n.y) < 0.9F ? Vec3f{0, 1, 0} : Vec3f{1, 0, 0};
    return normalized(cross(n, other));
}

/// Right-handed unit axes, of which z is given.
struct Axes {
    Vec3f x, y, z;

    explicit Axes(Vec3f unit) : x(anyNormal(unit)), y(cross(unit, x)), z(unit) {}
    Vec3f toWorld(Vec3f v) const { return v.x * x + v.y * y + v.z * z; }
    Vec3f toLocal(Vec3f v) const { return {dot(v, x), dot(v, y), dot(v, z)}; }
};

}  // namespace kushi
