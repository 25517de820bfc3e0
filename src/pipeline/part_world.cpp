// SPDX-License-Identifier: Apache-2.0
#include "pipeline/part_world.h"

namespace kushi {

RodWorld worldOf(const Style& style, const Part& part, const DistanceField* solids,
                 std::span<const float> frictions) {
    RodWorld world;
    world.gravity = style.gravity;
    world.forces = part.forces;
    // Hair that grows from a head below or above the ellipsoid is not kept out of that.
    if (part.scalp.surface == ScalpSurface::Ellipsoid) world.obstacle = &part.scalp.ellipsoid;
    world.obstacleFriction = static_cast<float>(style.headFriction);
    world.solids = solids;
    world.solidFrictions = frictions;
    return world;
}

}  // namespace kushi
