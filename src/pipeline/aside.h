// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <kushi/vec.h>

#include <algorithm>

namespace kushi {

/// The two ways off a strand.
struct Aside {
    Vec3d outward;   ///< away from the head, unit
    Vec3d sideways;  ///< across that and the strand, unit, or 0 where it runs outwards
};

/// tangent  of the strand there, of any length
/// middle   of the head [m]; of hair below it, outwards is horizontal
inline Aside asideOf(Vec3d place, Vec3d tangent, Vec3d middle) {
    middle.y = std::min(middle.y, place.y);
    const Vec3d away = place - middle;
    const double size = length(away);
    const Vec3d outward = size > 0 ? away / size : Vec3d{0, 1, 0};
    const Vec3d side = cross(tangent, outward);
    const double across = length(side);
    return {outward, across > 0 ? side / across : Vec3d{}};
}

}  // namespace kushi
