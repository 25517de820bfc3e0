// SPDX-License-Identifier: Apache-2.0
#include "commands.h"
#include "input.h"
#include "messages.h"
#include "report.h"
#include "settle_groom.h"

#include <kushi/groom_io.h>

#include <cstdio>

namespace kushi {

int runSettle(const SettleArguments& arguments) {
    const Result<bool> isStyle = isStylePath(arguments.input);
    if (!isStyle) return report(isStyle.problems());
    if (const Status ending = hasEnding(arguments.output, {".hair", ".ply", ".obj"}, "the output");
        !ending) {
        return report(ending.problems());
    }
    if (const Status outputs = checkOutputs(arguments.output, arguments.reportPath); !outputs) {
        return report(outputs.problems());
    }

    if (!*isStyle) return settleGroomFile(arguments);
    if (const Status fitting = noGroomFlags(arguments); !fitting) return report(fitting.problems());

    StageClock clock;
    const Result<Style> style = readStyle(arguments.input);
    if (!style) return report(style.problems());
    clock.end("read");
    const Result<SettledGroom> groom =
        settleWithProgress(*style, arguments.input, arguments.flags, !arguments.reportPath.empty());
    if (!groom) return report(groom.problems());
    clock.add(groom->report.stages);
    if (const Status written = writeGroom(groom->strands, arguments.output); !written) {
        return report(written.problems());
    }
    clock.end("write");
    if (const Status written = writeReport(arguments.reportPath, reportJson(groom->report, clock));
        !written) {
        return report(written.problems());
    }
    std::printf("%s: %s, %s (%s)\n", arguments.output.c_str(),
                counted(groom->report.strands, "strand").c_str(),
                counted(groom->report.segments, "segment").c_str(), timesLine(clock).c_str());
    if (groom->report.set) printHolding(*groom->report.set, groom->report.unsettled);
    return Done;
}

}  // namespace kushi
