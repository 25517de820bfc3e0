// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <kushi/distance_field.h>
#include <kushi/ellipsoid.h>

namespace kushi {

/// What hair is kept out of; either may be missing.
struct Obstacles {
    const Ellipsoid* ellipsoid = nullptr;
    const DistanceField* solids = nullptr;

    bool any() const { return ellipsoid != nullptr || solids != nullptr; }
};

/// Whether the walk must not end a segment here: in an ellipsoid whose implicit function is below
/// -1e-6, or in solids.
bool isInside(const Obstacles& obstacles, Vec3d point);

}  // namespace kushi
