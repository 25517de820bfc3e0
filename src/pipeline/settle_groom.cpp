// SPDX-License-Identifier: Apache-2.0
#include "pipeline/stopwatch.h"

#include <kushi/rest_shape.h>
#include <kushi/settle_groom.h>

#include <algorithm>
#include <cmath>

namespace kushi {

namespace {

// In which the loads and the hair change from what the groom was set under.
constexpr int steps = 16;
// How far gravity strays on the way, over its size: a strand that hangs straight and is turned
// upside down finds a side to fall to.
constexpr double sideways = 0.05;

bool changes(const GroomSettleOptions& options) {
    return !(options.gravity == options.setGravity) || options.weightScale != 1 ||
           options.stiffnessScale != 1 || options.set != 1;
}

void scale(std::vector<float>& values, double factor) {
    for (float& value : values)
        value = static_cast<float>(factor * value);
}

// The rods `share` of the way from how they were set to how they are to be.
Rods changed(const Rods& set, const GroomSettleOptions& options, double share) {
    const auto towards = [&](double end) { return 1 + share * (end - 1); };
    Rods rods = withStrength(set, towards(options.set));
    scale(rods.weights, towards(options.weightScale));
    scale(rods.bending, towards(options.stiffnessScale));
    scale(rods.twisting, towards(options.stiffnessScale));
    return rods;
}

// Gravity `share` of the way, and a little to one side until it is there.
Vec3d gravityAt(const GroomSettleOptions& options, double share) {
    const Vec3d from = options.setGravity;
    const Vec3d to = options.gravity;
    const Vec3d across =
        cross(from, std::abs(from.x) < std::abs(from.z) ? Vec3d{1, 0, 0} : Vec3d{0, 0, 1});
    if (share == 1 || length(across) == 0) return to;
    const double size = sideways * 4 * share * (1 - share) * std::max(length(from), length(to));
    return (1 - share) * from + share * to + size * normalized(across);
}

void describe(const SetGroom& set, GroomSettleReport& report) {
    report.unstable = set.unstable.size();
    report.unheld = set.unheld.size();
    std::vector<double> factors;
    for (const float factor : set.factors) {
        if (factor > 1 && std::isfinite(factor)) factors.push_back(factor);
    }
    report.stiffened = factors.size();
    if (factors.empty()) return;
    std::sort(factors.begin(), factors.end());
    report.stiffenedMedian = factors[factors.size() / 2];
    report.stiffenedMost = factors.back();
}

void describe(const RestReport& rest, GroomSettleReport& report) {
    report.unsettled = rest.unsettled.size();
    auto unsettled = rest.unsettled.begin();
    for (std::uint32_t i = 0; i < rest.residuals.size(); ++i) {
        if (unsettled != rest.unsettled.end() && *unsettled == i) {
            ++unsettled;
            continue;
        }
        report.maxResidual = std::max(report.maxResidual, static_cast<double>(rest.residuals[i]));
    }
}

}  // namespace

Result<SettledStrands> settleGroom(const Strands& groom, const GroomSettleOptions& options) {
    Stopwatch stopwatch;
    RodWorld world;
    world.gravity = options.setGravity;
    SetOptions setting;
    setting.threads = options.threads;
    Result<SetGroom> set = restShapeOf(groom, materialsOf(groom, options.hair), world, setting);
    if (!set) return set.problems();
    SettledStrands settled;
    settled.report.stages.push_back({"set", stopwatch.lap()});
    describe(*set, settled.report);

    const int count = changes(options) ? steps : 1;
    RestState state;
    RestOptions resting;
    resting.threads = options.threads;
    RestReport rest;
    std::vector<Vec3f> nodes(set->rods.nodeCount());
    for (int step = 1; step <= count; ++step) {
        const double share = static_cast<double>(step) / count;
        world.gravity = gravityAt(options, share);
        rest = settleRods(changed(set->rods, options, share), world, state, nodes, resting);
        resting.warm = true;
        if (options.progress) options.progress(share);
    }
    describe(rest, settled.report);

    settled.strands = groom;
    placeNodes(*set, nodes, settled.strands.nodes);
    settled.report.strands = groom.size();
    settled.report.segments = groom.segmentCount();
    settled.report.stages.push_back({"settle", stopwatch.lap()});
    return settled;
}

}  // namespace kushi
