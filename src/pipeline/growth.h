// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <kushi/style.h>

namespace kushi {

/// Where a hair grows.
struct RootPlace {
    Vec3d point;   ///< m, on the scalp's surface
    Vec3d normal;  ///< of the surface, unit
    EllipsoidAngles angles;
};

/// Unit direction in which a part's unloaded hair leaves the scalp: sin(lift) n + cos(lift) t,
/// where n is upright on it (or away from the ellipsoid's centre) and t across that, towards what
/// the hair leans to; n alone where that has no direction across it, as in the middle of a whorl.
Vec3d growthDirection(const Part& part, const RootPlace& root);

}  // namespace kushi
