// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <kushi/ellipsoid.h>

#include <vector>

namespace kushi {

/// A way from one point to another around an obstacle, as a polyline.
struct Route {
    std::vector<Vec3d> points;  ///< from first to last, at least two [m]
    double length = 0;          ///< m

    /// Unit direction `walked` metres along it; that of an end beyond it.
    Vec3d directionAt(double walked) const;
};

/// The way in the plane of the two points and the obstacle's centre: straight where that is free,
/// on the obstacle's surface, `clearance` above it, where it is not. Near a geodesic of a head.
///
/// from, to  may lie on the surface; not in line with the centre on opposite sides of it, where any
///           way around is as good: one is chosen
/// clearance  >= 0 [m]
Route around(const Ellipsoid& obstacle, Vec3d from, Vec3d to, double clearance);

}  // namespace kushi
