// SPDX-License-Identifier: Apache-2.0
#include "contact/avoidance.h"

#include <cmath>
#include <initializer_list>
#include <numbers>

namespace kushi {

namespace {

// What of `v` is normal to the unit vector `axis`, or zero where that is only rounding.
Vec3d normalPart(Vec3d v, Vec3d axis) {
    const Vec3d part = v - dot(v, axis) * axis;
    return dot(part, part) > 1e-18 * dot(v, v) ? normalized(part) : Vec3d{};
}

// Unit vector normal to `direction` in the plane to turn in, on the side of the axis before ->
// from.
Vec3d turningSide(const Ellipsoid& obstacle, Vec3d before, Vec3d from, Vec3d direction) {
    for (const Vec3d other :
         {from - before, obstacle.normal(from), Vec3d{0, 1, 0}, Vec3d{1, 0, 0}}) {
        const Vec3d side = normalPart(other, direction);
        if (dot(side, side) > 0) return side;
    }
    return {};
}

// How many of the angles 90, 45, ... keep the end outside before one does not.
int lastingSteps(const Ellipsoid& obstacle, Vec3d from, Vec3d along, Vec3d aside, int steps) {
    double angle = std::numbers::pi / 2;
    for (int step = 0; step < steps; ++step, angle /= 2) {
        if (isInside(obstacle, from + std::cos(angle) * along + std::sin(angle) * aside))
            return step;
    }
    return steps;
}

}  // namespace

bool isInside(const Ellipsoid& obstacle, Vec3d point) {
    return obstacle.implicit(point) < -1e-6;
}

Vec3d avoid(const Ellipsoid& obstacle, Vec3d before, Vec3d from, Vec3d to, int steps) {
    const Vec3d along = to - from;
    const double size = length(along);
    const Vec3d aside = size * turningSide(obstacle, before, from, along / size);

    const int plus = lastingSteps(obstacle, from, along, aside, steps);
    const int minus = lastingSteps(obstacle, from, along, -aside, steps);
    const bool takePlus = plus >= minus;
    const double angle = std::numbers::pi / std::exp2(takePlus ? plus : minus);
    return from + std::cos(angle) * along + (takePlus ? 1 : -1) * std::sin(angle) * aside;
}

}  // namespace kushi
