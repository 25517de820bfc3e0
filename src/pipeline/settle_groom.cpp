// SPDX-License-Identifier: Apache-2.0
#include "pipeline/change.h"
#include "pipeline/holding.h"
#include "pipeline/set_outside.h"
#include "pipeline/stopwatch.h"

#include <kushi/push_out.h>
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
    SettledStrands settled;
    settled.strands = groom;
    GroomSettleReport& report = settled.report;
    const Result<OutsideGroom> outside =
        setOutside(options.solids, settled.strands, options.hair, world, options.threads);
    if (!outside) return outside.problems();
    const SetGroom& set = outside->set;
    report.pushedOut = outside->pushedOut;
    report.stages.push_back({"set", stopwatch.lap()});
    report.set = describe({set.factors, set.unstable.size(), set.unheld.size()});

    Change change;
    change.setGravity = options.setGravity;
    change.gravity = options.gravity;
    change.weight = options.weightScale;
    change.bending = change.twisting = options.stiffnessScale;
    change.set = options.set;
    change.solids = options.solids;
    change.solidFrictions = options.frictions;
    change.layers = outside->skins;
    const ChangedGroom changed = settleChanged(set, change, options.threads, options.progress);
    describe(changed.report, report);

    placeNodes(set, changed.nodes, settled.strands.nodes);
    if (options.solids != nullptr) {
        report.stuck = pushOut(*options.solids, settled.strands, options.threads).stuck;
        report.penetration = penetrationOf(*options.solids, settled.strands, options.threads);
    }
    report.strands = groom.size();
    report.segments = groom.segmentCount();
    report.stages.push_back({"settle", stopwatch.lap()});
    return settled;
}

}  // namespace kushi
