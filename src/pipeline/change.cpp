// SPDX-License-Identifier: Apache-2.0
#include "pipeline/change.h"

#include <algorithm>
#include <cmath>

namespace kushi {

namespace {

// In which the loads and the hair change from what the groom was set under.
constexpr int steps = 16;
// How well strands come to rest on the way.
constexpr double roughly = 1e-3;
// How far gravity strays on the way, over its size: a strand that hangs straight and is turned
// upside down finds a side to fall to.
constexpr double sideways = 0.05;

bool isAny(const Change& change) {
    return !(change.gravity == change.setGravity) || change.weight != 1 || change.bending != 1 ||
           change.twisting != 1 || change.set != 1 || !change.forces.empty();
}

// The rods `share` of the way from how they were set to how they are to be.
Rods rodsAt(const SetGroom& set, const Change& change, double share) {
    const auto towards = [&](double end) { return 1 + share * (end - 1); };
    const double strength = towards(change.set);
    Rods rods = withStrength(set.rods, strength);
    for (std::size_t i = 0; i < rods.size(); ++i) {
        // As much of what the strand was stiffened by as of its shape.
        const double whole = std::isfinite(set.factors[i]) ? set.factors[i] : 1;
        const double kept = (1 + strength * (whole - 1)) / whole;
        rods.bending[i] = static_cast<float>(rods.bending[i] * kept * towards(change.bending));
        rods.twisting[i] = static_cast<float>(rods.twisting[i] * kept * towards(change.twisting));
        rods.weights[i] = static_cast<float>(rods.weights[i] * towards(change.weight));
    }
    return rods;
}

// Gravity `share` of the way, and a little to one side until it is there.
Vec3d gravityAt(const Change& change, double share) {
    const Vec3d from = change.setGravity;
    const Vec3d to = change.gravity;
    const Vec3d across =
        cross(from, std::abs(from.x) < std::abs(from.z) ? Vec3d{1, 0, 0} : Vec3d{0, 0, 1});
    if (share == 1 || length(across) == 0) return to;
    const double size = sideways * 4 * share * (1 - share) * std::max(length(from), length(to));
    return (1 - share) * from + share * to + size * normalized(across);
}

}  // namespace

ChangedGroom settleChanged(const SetGroom& set, const Change& change, int threads,
                           const std::function<void(double)>& progress) {
    ChangedGroom changed;
    changed.nodes.resize(set.rods.nodeCount());
    std::vector<Force> forces(change.forces.begin(), change.forces.end());
    RodWorld world;
    world.forces = forces;
    world.rootShares = change.rootShares;
    world.solids = change.solids;
    world.solidFrictions = change.solidFrictions;
    world.layers = change.layers;
    RestState state;
    RestOptions options;
    options.threads = threads;
    const int count = isAny(change) ? steps : 1;
    for (int step = 1; step <= count; ++step) {
        const double share = static_cast<double>(step) / count;
        for (std::size_t f = 0; f < forces.size(); ++f)
            forces[f].magnitude = share * change.forces[f].magnitude;
        options.tolerance = step < count ? roughly : RestOptions().tolerance;
        world.gravity = gravityAt(change, share);
        changed.rods = rodsAt(set, change, share);
        // Where a strand that is lost on the way begins anew.
        if (step > 1) changed.rods.starts = framesAtRest(changed.rods, state);
        changed.report = settleRods(changed.rods, world, state, changed.nodes, options);
        options.warm = true;
        if (progress) progress(share);
    }
    changed.rods.starts = framesAtRest(changed.rods, state);
    return changed;
}

}  // namespace kushi
