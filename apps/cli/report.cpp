// SPDX-License-Identifier: Apache-2.0
#include "report.h"

#include "messages.h"

#include <algorithm>
#include <cstdio>

namespace kushi {

void StageClock::end(const std::string& stage) {
    const auto now = std::chrono::steady_clock::now();
    const std::chrono::duration<double, std::milli> passed = now - last_;
    last_ = now;
    stages_.push_back({stage, passed.count()});
}

void StageClock::add(const std::vector<StageTime>& stages) {
    last_ = std::chrono::steady_clock::now();
    stages_.insert(stages_.end(), stages.begin(), stages.end());
}

double StageClock::total() const {
    double sum = 0;
    for (const StageTime& stage : stages_)
        sum += stage.milliseconds;
    return sum;
}

nlohmann::ordered_json setJson(const SetReport& set) {
    return {{"unstable", set.unstable},
            {"unheld", set.unheld},
            {"stiffened", set.stiffened},
            {"stiffened_median", set.stiffenedMedian},
            {"stiffened_max", set.stiffenedMost}};
}

void printHolding(const SetReport& set, std::size_t unsettled) {
    if (set.stiffened > 0) {
        std::printf("made stiffer to hold: %s, by %.3g in the median and %.3g at most\n",
                    counted(set.stiffened, "strand").c_str(), set.stiffenedMedian,
                    set.stiffenedMost);
    }
    if (set.unheld > 0)
        std::printf("too long or too heavy to hold: %s\n", counted(set.unheld, "strand").c_str());
    if (unsettled > 0) std::printf("not at rest: %s\n", counted(unsettled, "strand").c_str());
}

namespace {

nlohmann::ordered_json settleJson(const SettleReport& report, const StageClock& clock) {
    nlohmann::ordered_json json;
    json["strands"] = report.strands;
    json["segments"] = report.segments;
    for (const StageTime& stage : clock.stages())
        json["wall_ms"][stage.stage] = stage.milliseconds;
    json["wall_ms"]["total"] = clock.total();
    json["max_penetration_cm"] = nullptr;
    double deepest = 0;
    for (const PartPenetration& part : report.penetration) {
        deepest = std::max(deepest, part.found.deepest);
        json["penetration"].push_back({{"part", part.part},
                                       {"deepest_cm", 100 * part.found.deepest},
                                       {"strands", part.found.strands}});
    }
    if (!report.penetration.empty()) json["max_penetration_cm"] = 100 * deepest;
    json["pushed_out"] = report.pushedOut;
    json["stuck"] = report.stuck;
    if (report.crowding) {
        json["max_packing"] = report.crowding->packing;
        json["volume_cm3"] = 1e6 * report.crowding->volume;
    }
    if (report.solidsSpacing) json["solids_spacing_cm"] = 100 * *report.solidsSpacing;
    json["max_residual"] = nullptr;
    if (report.maxResidual) json["max_residual"] = *report.maxResidual;
    json["unsettled"] = report.unsettled;
    if (report.set) json["set"] = setJson(*report.set);
    json["clumps"] = report.clumps;
    json["flyaways"] = report.flyaways;
    return json;
}

}  // namespace

void printPenetration(const std::string& what, const Penetration& found) {
    if (found.strands == 0) {
        std::printf("%s: none is inside (%.3f cm at most)\n", what.c_str(), 100 * found.deepest);
        return;
    }
    std::printf("%s: %s inside, by %.3f cm at most\n", what.c_str(),
                counted(found.strands, "strand").c_str(), 100 * found.deepest);
}

std::string reportJson(const SettleReport& report, const StageClock& clock) {
    return settleJson(report, clock).dump(2) + '\n';
}

std::string renderReportJson(const SettleReport& report, const std::vector<ScalpShowing>& showing,
                             const StageClock& clock) {
    nlohmann::ordered_json json = settleJson(report, clock);
    json["scalp_showing"] = nullptr;
    double most = 0;
    for (const ScalpShowing& view : showing) {
        json["scalp_showing"][view.view] = view.share;
        most = std::max(most, view.share);
    }
    if (!showing.empty()) json["scalp_showing"]["max"] = most;
    return json.dump(2) + '\n';
}

std::string timesLine(const StageClock& clock) {
    std::string line;
    for (const StageTime& stage : clock.stages()) {
        char text[64];
        std::snprintf(text, sizeof text, "%s%s %.0f ms", line.empty() ? "" : ", ",
                      stage.stage.c_str(), stage.milliseconds);
        line += text;
    }
    return line;
}

}  // namespace kushi
