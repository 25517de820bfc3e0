// SPDX-License-Identifier: Apache-2.0
#include "pipeline/strand.h"

#include "pipeline/cut.h"
#include "pipeline/grow.h"
#include "style/ranges.h"

#include <algorithm>
#include <cmath>

namespace kushi {

namespace {

std::vector<ActiveForce> forcesOn(const Part& part, EllipsoidAngles root) {
    std::vector<ActiveForce> active;
    for (const Force& force : part.forces) {
        const double rootShare = share(force.roots, root, force.falloff.angle);
        if (rootShare > 0) active.push_back({&force, rootShare});
    }
    return active;
}

CantileverRod unbentRod(const Part& part, const StrandSite& site) {
    CantileverRod rod;
    rod.root = site.root;
    rod.direction = growthDirection(part, site.root);
    rod.length = grownLength(part.hair, site.key);
    rod.rigidity = part.hair.rigidity();
    rod.weight = part.hair.weightPerLength();
    return rod;
}

std::vector<Vec3d> bend(const CantileverRod& rod, const CantileverWorld& world, double segments) {
    std::vector<Vec3d> nodes(static_cast<std::size_t>(segments) + 1);
    bendCantilever(rod, world, nodes);
    return nodes;
}

}  // namespace

// What a hide cut leaves is a length along the strand; later cuts see only that much. A settle cut
// really shortens the strand, and what a hide cut had left out beyond goes with the rest.
std::vector<Vec3d> settleStrand(const Style& style, const Part& part, const StrandSite& site,
                                int segments) {
    const std::vector<ActiveForce> forces = forcesOn(part, site.angles);
    CantileverWorld world;
    world.gravity = style.gravity;
    world.forces = forces;
    world.obstacle = &part.scalp.ellipsoid;
    world.avoidanceSteps = style.solver.avoidanceSteps;

    CantileverRod rod = unbentRod(part, site);
    const double segmentLength = rod.length / segments;
    std::vector<Vec3d> nodes = bend(rod, world, segments);
    const double cutAt = cutPlace(site.key);
    for (const Cut& cut : part.cuts) {
        const double rootShare = share(cut.roots, site.angles, cut.falloff.angle);
        if (rootShare <= 0) continue;
        const auto left = lengthLeft(cut, nodes, cutAt, rootShare);
        if (!left) continue;
        if (*left <= 0) return {};
        if (cut.mode == CutMode::Hide) {
            nodes = clipped(nodes, *left);
        } else {
            rod.length = *left;
            nodes = bend(rod, world, std::max(1.0, std::ceil(*left / segmentLength - 1e-9)));
        }
    }
    return nodes;
}

}  // namespace kushi
