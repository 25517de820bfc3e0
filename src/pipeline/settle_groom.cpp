// SPDX-License-Identifier: Apache-2.0
#include "pipeline/change.h"
#include "pipeline/holding.h"
#include "pipeline/stopwatch.h"

#include <kushi/settle_groom.h>

#include <algorithm>

namespace kushi {

namespace {

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
    settled.report.set = describe({set->factors, set->unstable.size(), set->unheld.size()});

    Change change;
    change.setGravity = options.setGravity;
    change.gravity = options.gravity;
    change.weight = options.weightScale;
    change.bending = change.twisting = options.stiffnessScale;
    change.set = options.set;
    const ChangedGroom changed = settleChanged(*set, change, options.threads, options.progress);
    describe(changed.report, settled.report);

    settled.strands = groom;
    placeNodes(*set, changed.nodes, settled.strands.nodes);
    settled.report.strands = groom.size();
    settled.report.segments = groom.segmentCount();
    settled.report.stages.push_back({"settle", stopwatch.lap()});
    return settled;
}

}  // namespace kushi
