// SPDX-License-Identifier: Apache-2.0
//
// Usami & Anjyo, "Hairstyle Modeling Technique Using Flexural Rigidity", Trans. IPSJ 33(7), 1992,
// section 2.2. Plain and in double precision: the reference for faster ones.
#include "contact/avoidance.h"
#include "style/ranges.h"

#include <kushi/cantilever.h>

#include <cmath>

namespace kushi {

namespace {

// The axes across the segment (figure 4): a1 in the vertical plane through a0, a2 = a0 x a1.
struct Axes {
    Vec3d a1, a2;
};

Axes axesAcross(Vec3d a0) {
    const auto across = [a0](Vec3d v) { return v - dot(v, a0) * a0; };
    Vec3d a1 = across({0, 1, 0});
    if (dot(a1, a1) < 1e-18) a1 = across({1, 0, 0});
    a1 = normalized(a1);
    return {a1, cross(a0, a1)};
}

Vec3d directionAt(const ForceDirection& direction, Vec3d point) {
    if (!direction.radial) return direction.vector;
    const double distance = std::hypot(point.x, point.z);
    return distance > 0 ? Vec3d{point.x / distance, 0, point.z / distance} : Vec3d{};
}

}  // namespace

Vec3d loadAt(const CantileverWorld& world, Vec3d point) {
    Vec3d load = world.gravity;
    for (const auto& [force, rootShare] : world.forces) {
        const double part = rootShare * share(force->within, point, force->falloff.distance);
        if (part > 0) load += (part * force->magnitude) * directionAt(force->direction, point);
    }
    return load;
}

void bendCantilever(const CantileverRod& rod, const CantileverWorld& world,
                    std::span<Vec3d> nodes) {
    const std::size_t n = nodes.size() - 1;
    const double d = rod.length / static_cast<double>(n);
    Vec3d before = rod.root - d * rod.direction;
    nodes[0] = rod.root;

    for (std::size_t i = 1; i <= n; ++i) {
        const Vec3d from = nodes[i - 1];
        const Vec3d a0 = normalized(from - before);
        const auto [a1, a2] = axesAcross(a0);
        const auto m = static_cast<double>(n - i + 1);

        // The loads F at each of the m nodes ahead have their mean moment arm over this segment in
        // d m^2 / 2, the tip load has its own in d (m - 1/2).
        const Vec3d force = rod.weight * d * loadAt(world, from);
        const Vec3d moment = (d * m * m / 2) * force + (d * (m - 0.5)) * world.tipLoad;
        const double compliance = d * d / (2 * rod.rigidity);
        const Vec3d end =
            d * a0 + (compliance * dot(moment, a1)) * a1 + (compliance * dot(moment, a2)) * a2;

        Vec3d to = from + d * normalized(end);
        const Obstacles obstacles = {world.obstacle, world.solids};
        if (isInside(obstacles, to)) to = avoid(obstacles, before, from, to, world.avoidanceSteps);
        nodes[i] = to;
        before = from;
    }
}

}  // namespace kushi
