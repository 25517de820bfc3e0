// SPDX-License-Identifier: Apache-2.0
#include "pipeline/lay_under.h"

#include "contact/route.h"
#include "pipeline/start_along.h"

#include <algorithm>

namespace kushi {

namespace {

constexpr double leaning = 2;  // what it counts where hair grows to, against where its root is

// Where a strand goes that is laid over the head: beside it, as far below as the strand is long.
Vec3d goalOf(const Ellipsoid& head, Vec3d down, Vec3d root, Vec3d growth, double length) {
    const auto level = [down](Vec3d v) { return v - dot(v, down) * down; };
    const Vec3d normal = head.normal(root);
    const Vec3d lean = growth - dot(growth, normal) * normal;
    const Vec3d aside = level(normalized(root - head.center) + leaning * lean);
    const Vec3d side =
        kushi::length(aside) > 1e-3 ? normalized(aside) : normalized(level({-1, 0, 0.1}));
    const double widest = std::max({head.semiAxes.x, head.semiAxes.y, head.semiAxes.z});
    return head.center + (widest + overHead) * side + (widest + length) * down;
}

}  // namespace

bool isCovered(const DistanceField& solids, Vec3d root, Vec3d normal) {
    constexpr int from = 5;  // beyond the head's own surface [mm]
    constexpr int to = 40;
    for (int way = from; way < to; ++way)
        if (distanceAt(solids, (root + 1e-3 * way * normal).as<float>()) < 0) return true;
    return false;
}

void layUnder(const Ellipsoid& head, Vec3d gravity, Rods& rods) {
    const Vec3d down = fallOf(gravity);
    for (std::uint32_t i = 0; i < rods.size(); ++i) {
        const Vec3d root = rods.roots[i].as<double>();
        const Route way = around(head, root,
                                 goalOf(head, down, root, directionOf(rods.clamps[i]),
                                        static_cast<double>(rods.lengths[i])),
                                 overHead);
        startAlong(rods, i, [&](double walked) { return way.directionAt(walked); });
    }
}

}  // namespace kushi
