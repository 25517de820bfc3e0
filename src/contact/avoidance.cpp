// SPDX-License-Identifier: Apache-2.0
#include "contact/avoidance.h"

#include "contact/field_probe.h"

#include <cmath>
#include <initializer_list>
#include <numbers>

namespace kushi {

namespace {

// What of `v` is normal to the unit vector `axis`, or zero where that is only rounding, be it of
// floats: the walk of many strands takes the same turns.
Vec3d normalPart(Vec3d v, Vec3d axis) {
    const Vec3d part = v - dot(v, axis) * axis;
    return dot(part, part) > 1e-13 * dot(v, v) ? normalized(part) : Vec3d{};
}

// Outward at `from`, unit, of what `to` lies in.
Vec3d outward(const Obstacles& obstacles, Vec3d from, Vec3d to) {
    const bool inEllipsoid =
        obstacles.ellipsoid != nullptr && isInside({obstacles.ellipsoid, nullptr}, to);
    const bool alone = obstacles.solids == nullptr;
    if (obstacles.ellipsoid != nullptr && (inEllipsoid || alone))
        return obstacles.ellipsoid->normal(from);
    return alone ? Vec3d{0, 1, 0} : outwardAt(*obstacles.solids, from);
}

// Unit vector normal to `direction` in the plane to turn in, on the side of the axis before ->
// from.
Vec3d turningSide(Vec3d outward, Vec3d before, Vec3d from, Vec3d direction) {
    for (const Vec3d other : {from - before, outward, Vec3d{0, 1, 0}, Vec3d{1, 0, 0}}) {
        const Vec3d side = normalPart(other, direction);
        if (dot(side, side) > 0) return side;
    }
    return {};
}

// How many of the angles 90, 45, ... keep the end outside before one does not.
int lastingSteps(const Obstacles& obstacles, Vec3d from, Vec3d along, Vec3d aside, int steps) {
    double angle = std::numbers::pi / 2;
    for (int step = 0; step < steps; ++step, angle /= 2) {
        if (isInside(obstacles, from + std::cos(angle) * along + std::sin(angle) * aside))
            return step;
    }
    return steps;
}

}  // namespace

Vec3d avoid(const Obstacles& obstacles, Vec3d before, Vec3d from, Vec3d to, int steps) {
    const Vec3d along = to - from;
    const double size = length(along);
    const Vec3d away = outward(obstacles, from, to);
    const Vec3d aside = size * turningSide(away, before, from, along / size);

    const int plus = lastingSteps(obstacles, from, along, aside, steps);
    const int minus = lastingSteps(obstacles, from, along, -aside, steps);
    if (plus == 0 && minus == 0) return from + size * away;
    const bool takePlus = plus >= minus;
    const double angle = std::numbers::pi / std::exp2(takePlus ? plus : minus);
    return from + std::cos(angle) * along + (takePlus ? 1 : -1) * std::sin(angle) * aside;
}

}  // namespace kushi
