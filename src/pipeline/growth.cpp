// SPDX-License-Identifier: Apache-2.0
#include "pipeline/growth.h"

#include <cmath>

namespace kushi {

namespace {

Vec3d across(Vec3d direction, Vec3d normal) {
    return direction - dot(direction, normal) * normal;
}

// By the ellipsoid's own places, so that a whorl is the same on every head.
Vec3d fromWhorl(const Ellipsoid& ellipsoid, const Whorl& whorl, EllipsoidAngles angles) {
    const Vec3d here = ellipsoid.point(angles);
    const Vec3d normal = ellipsoid.normal(here);
    const Vec3d away = across(here - ellipsoid.point(whorl.at), normal);
    return std::cos(whorl.turn) * away + std::sin(whorl.turn) * cross(normal, away);
}

Vec3d wanted(const Part& part, const RootPlace& root) {
    const Lean& lean = part.hair.lean;
    if (lean.whorl) return fromWhorl(part.scalp.ellipsoid, *lean.whorl, root.angles);
    const Vec3d direction =
        lean.direction.radial ? Vec3d{root.point.x, 0, root.point.z} : lean.direction.vector;
    return lean.reversed ? -direction : direction;
}

}  // namespace

Vec3d growthDirection(const Part& part, const RootPlace& root) {
    const Hair& hair = part.hair;
    const Vec3d upright = hair.growth == Growth::Radial
                              ? normalized(root.point - part.scalp.ellipsoid.center)
                              : root.normal;
    if (hair.lift == Hair().lift) return upright;
    const Vec3d aim = wanted(part, root);
    const Vec3d aside = across(aim, upright);
    const double size = length(aside);
    if (!(size > 1e-6 * length(aim))) return upright;
    return normalized(std::sin(hair.lift) * upright + std::cos(hair.lift) / size * aside);
}

}  // namespace kushi
