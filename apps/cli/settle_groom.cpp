// SPDX-License-Identifier: Apache-2.0
//
// `kushi settle` of a groom made elsewhere.
#include "settle_groom.h"

#include "input.h"
#include "messages.h"
#include "progress.h"
#include "report.h"

#include <kushi/groom_io.h>
#include <kushi/settle_groom.h>

#include <charconv>
#include <cmath>
#include <cstdio>

#include <nlohmann/json.hpp>

namespace kushi {

namespace {

// "X,Y,Z".
std::optional<Vec3d> readVector(const std::string& text) {
    double numbers[3];
    const char* at = text.data();
    const char* end = at + text.size();
    for (int i = 0; i < 3; ++i) {
        if (i > 0 && (at == end || *at++ != ',')) return {};
        const auto [next, error] = std::from_chars(at, end, numbers[i]);
        if (error != std::errc() || !std::isfinite(numbers[i])) return {};
        at = next;
    }
    if (at != end) return {};
    return Vec3d{numbers[0], numbers[1], numbers[2]};
}

std::optional<Vec3d> readAxis(const std::string& name) {
    if (name == "x") return Vec3d{1, 0, 0};
    if (name == "-x") return Vec3d{-1, 0, 0};
    if (name == "y") return Vec3d{0, 1, 0};
    if (name == "-y") return Vec3d{0, -1, 0};
    if (name == "z") return Vec3d{0, 0, 1};
    if (name == "-z") return Vec3d{0, 0, -1};
    return {};
}

bool keptOut(const GroomFlags& flags) {
    return flags.pushOut || !flags.solids.empty();
}

Result<GroomSettleOptions> optionsOf(const SettleArguments& arguments) {
    const SettleFlags& flags = arguments.flags;
    if (flags.count || flags.segments) {
        return Problem{"--count and --segments are for styles; a groom keeps its strands and nodes",
                       arguments.input};
    }
    if (flags.method == "cantilever") {
        return Problem{
            "--method cantilever is for styles; a groom settles by true rest, leave "
            "--method out",
            arguments.input};
    }
    const GroomFlags& changes = arguments.groom;
    GroomSettleOptions options;
    options.threads = flags.threads;
    if (!changes.up.empty()) {
        const auto up = readAxis(changes.up);
        if (!up) return Problem{"--up " + changes.up + ": give x, y, z, -x, -y or -z"};
        options.setGravity = -*up;
        if (keptOut(changes) && changes.up != "y") {
            return Problem{"--up " + changes.up +
                               ": the head of --push-out and --solids stands upright; name the "
                               "groom in a style, with its up and front",
                           arguments.input};
        }
    }
    options.gravity = options.setGravity;
    if (!changes.gravity.empty()) {
        const auto gravity = readVector(changes.gravity);
        if (!gravity || length(*gravity) > 1000) {
            return Problem{"--gravity " + changes.gravity +
                           ": give X,Y,Z in multiples of the earth's, as in 0,-1,0"};
        }
        options.gravity = *gravity;
    }
    options.weightScale = changes.weightScale.value_or(1);
    options.stiffnessScale = changes.stiffnessScale.value_or(1);
    options.set = changes.set.value_or(1);
    return options;
}

// From the file's unit to metres, or back.
void scale(Strands& groom, double factor) {
    if (factor == 1) return;
    for (Vec3f& node : groom.nodes)
        node = (factor * node.as<double>()).as<float>();
    for (float& diameter : groom.diameters)
        diameter = static_cast<float>(factor * diameter);
}

std::string groomReportJson(const GroomSettleReport& report, const StageClock& clock) {
    nlohmann::ordered_json json;
    json["strands"] = report.strands;
    json["segments"] = report.segments;
    for (const StageTime& stage : clock.stages())
        json["wall_ms"][stage.stage] = stage.milliseconds;
    json["wall_ms"]["total"] = clock.total();
    json["max_penetration_cm"] = nullptr;
    if (report.penetration) json["max_penetration_cm"] = 100 * report.penetration->deepest;
    json["max_residual"] = report.maxResidual;
    json["unsettled"] = report.unsettled;
    json["set"] = setJson(report.set);
    if (report.penetration) {
        json["inside"] = report.penetration->strands;
        json["pushed_out"] = report.pushedOut;
        json["stuck"] = report.stuck;
    }
    return json.dump(2) + '\n';
}

}  // namespace

Status noGroomFlags(const SettleArguments& arguments) {
    const GroomFlags& given = arguments.groom;
    if (given.gravity.empty() && given.up.empty() && !given.weightScale && !given.stiffnessScale &&
        !given.set && !given.unit && !given.pushOut && given.solids.empty()) {
        return std::monostate{};
    }
    return Problem{
        "--gravity, --weight-scale, --stiffness-scale, --set, --up, --unit, --push-out and "
        "--solids are for grooms; a style says it itself (gravity, groom, [hair] density, "
        "stiffness and set) and always keeps its hair out of head and colliders",
        arguments.input};
}

int settleGroomFile(const SettleArguments& arguments) {
    Result<GroomSettleOptions> options = optionsOf(arguments);
    if (!options) return report(options.problems());
    StageClock clock;
    Result<Strands> groom = readGroom(arguments.input);
    if (!groom) return report(groom.problems());
    const double unit = arguments.groom.unit.value_or(1);
    scale(*groom, unit);
    clock.end("read");

    Solids solids;
    if (keptOut(arguments.groom)) {
        Result<Solids> found = solidsFor(arguments.groom.solids, arguments.input, options->threads);
        if (!found) return report(found.problems());
        solids = std::move(*found);
        options->solids = &solids.field;
        options->frictions = solids.frictions;
        clock.end("solids");
    }

    ProgressBar bar("settling");
    options->progress = [&bar](double share) { bar.show(share); };
    Result<SettledStrands> settled = settleGroom(*groom, *options);
    if (!settled) {
        std::vector<Problem> problems = settled.problems();
        for (Problem& problem : problems)
            problem.file = arguments.input;
        return report(problems);
    }
    clock.add(settled->report.stages);
    scale(settled->strands, 1 / unit);
    if (const Status written = writeGroom(settled->strands, arguments.output); !written)
        return report(written.problems());
    clock.end("write");
    const GroomSettleReport& told = settled->report;
    if (const Status written = writeReport(arguments.reportPath, groomReportJson(told, clock));
        !written) {
        return report(written.problems());
    }
    std::printf("%s: %s, %s (%s)\n", arguments.output.c_str(),
                counted(told.strands, "strand").c_str(), counted(told.segments, "segment").c_str(),
                timesLine(clock).c_str());
    printHolding(told.set, told.unsettled);
    if (told.penetration) {
        std::printf("pushed out: %s\n", counted(told.pushedOut, "strand").c_str());
        if (told.stuck > 0) std::printf("not free: %s\n", counted(told.stuck, "strand").c_str());
    }
    return Done;
}

}  // namespace kushi
