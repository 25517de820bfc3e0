// SPDX-License-Identifier: Apache-2.0
#include "contact/obstacles.h"

namespace kushi {

bool isInside(const Obstacles& obstacles, Vec3d point) {
    if (obstacles.ellipsoid != nullptr && obstacles.ellipsoid->implicit(point) < -1e-6) return true;
    return obstacles.solids != nullptr && distanceAt(*obstacles.solids, point.as<float>()) < 0;
}

}  // namespace kushi
