// SPDX-License-Identifier: Apache-2.0
#include "contact/route.h"

#include <algorithm>
#include <cmath>

namespace kushi {

namespace {

constexpr int arcPieces = 48;

// In units of the semi-axes, where the obstacle is the unit sphere.
Vec3d toSphere(const Ellipsoid& obstacle, Vec3d world) {
    const Vec3d local = obstacle.toLocal(world);
    return {local.x / obstacle.semiAxes.x, local.y / obstacle.semiAxes.y,
            local.z / obstacle.semiAxes.z};
}

Vec3d toWorld(const Ellipsoid& obstacle, Vec3d sphere) {
    return obstacle.center + obstacle.toWorldDirection({sphere.x * obstacle.semiAxes.x,
                                                        sphere.y * obstacle.semiAxes.y,
                                                        sphere.z * obstacle.semiAxes.z});
}

}  // namespace

Vec3d Route::directionAt(double walked) const {
    for (std::size_t i = 1; i + 1 < points.size(); ++i) {
        const Vec3d step = points[i] - points[i - 1];
        const double size = kushi::length(step);
        if (size > 0 && walked < size) return step / size;
        walked -= size;
    }
    return normalized(points.back() - points[points.size() - 2]);
}

Route around(const Ellipsoid& obstacle, Vec3d from, Vec3d to, double clearance) {
    const Vec3d u = toSphere(obstacle, from);
    const Vec3d v = toSphere(obstacle, to);
    const Vec3d first = normalized(u);
    // Across, in the plane; over the top where the ends lie opposite each other.
    Vec3d across = v - dot(v, first) * first;
    if (length(across) < 1e-6) across = cross(cross(first, Vec3d{0, 1, 0}), first);
    if (length(across) < 1e-6) across = {1, 0, 0};
    across = normalized(across);

    // A taut string leaves the sphere along its tangents.
    const double angle = std::atan2(dot(v, across), dot(v, first));
    const double leave = std::acos(std::min(1.0, 1 / length(u)));
    const double arrive = angle - std::acos(std::min(1.0, 1 / length(v)));
    Route route;
    route.points.push_back(from);
    for (int i = 0; leave < arrive && i <= arcPieces; ++i) {
        const double at = leave + (arrive - leave) * i / arcPieces;
        const Vec3d surface = toWorld(obstacle, std::cos(at) * first + std::sin(at) * across);
        const Vec3d raised = surface + clearance * obstacle.normal(surface);
        if (i > 0 || leave > 0) route.points.push_back(raised);
    }
    route.points.push_back(to);
    for (std::size_t i = 1; i < route.points.size(); ++i)
        route.length += length(route.points[i] - route.points[i - 1]);
    return route;
}

}  // namespace kushi
