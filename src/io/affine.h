// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <kushi/vec.h>

namespace kushi {

/// A linear map, by what becomes of the axes, and a shift.
struct Affine {
    Vec3d x = {1, 0, 0}, y = {0, 1, 0}, z = {0, 0, 1};
    Vec3d shift;

    Vec3d linear(Vec3d v) const { return v.x * x + v.y * y + v.z * z; }
    Vec3d point(Vec3d p) const { return linear(p) + shift; }
    /// Whether it turns left into right.
    bool mirrors() const { return dot(cross(x, y), z) < 0; }
    /// What becomes of the normal of a surface; of any length.
    Vec3d normal(Vec3d n) const {
        const Vec3d turned = n.x * cross(y, z) + n.y * cross(z, x) + n.z * cross(x, y);
        return mirrors() ? -turned : turned;
    }

    /// First b, then a.
    friend Affine operator*(const Affine& a, const Affine& b) {
        return {a.linear(b.x), a.linear(b.y), a.linear(b.z), a.point(b.shift)};
    }
};

}  // namespace kushi
