// SPDX-License-Identifier: Apache-2.0
#include <cstdio>
#include <memory>

#include "commands.h"
#include "input.h"
#include "messages.h"
#include "report.h"
#include "settle_flags.h"

#include <kushi/groom_io.h>

namespace kushi {

namespace {

struct SettleArguments {
    std::string input, output, reportPath;
    SettleFlags flags;
};

int run(const SettleArguments& arguments) {
    const Result<bool> isStyle = isStylePath(arguments.input);
    if (!isStyle) return report(isStyle.problems());
    if (!*isStyle) {
        return report({{"settling a groom made elsewhere needs the equilibrium method, which this version "
                        "does not have yet; give a style (.toml)",
                        arguments.input}});
    }
    if (const Status ending = hasEnding(arguments.output, {".hair", ".ply", ".obj"}, "the output"); !ending) {
        return report(ending.problems());
    }

    StageClock clock;
    const Result<Style> style = readStyle(arguments.input);
    if (!style) return report(style.problems());
    clock.end("read");
    const Result<SettledGroom> groom = settleWithProgress(*style, arguments.input, arguments.flags,
                                                          !arguments.reportPath.empty());
    if (!groom) return report(groom.problems());
    clock.add(groom->report.stages);
    if (const Status written = writeGroom(groom->strands, arguments.output); !written) {
        return report(written.problems());
    }
    clock.end("write");
    if (const Status written = writeReport(arguments.reportPath, reportJson(groom->report, clock)); !written) {
        return report(written.problems());
    }
    std::printf("%s: %s strands, %s segments (%s)\n", arguments.output.c_str(),
                grouped(groom->report.strands).c_str(), grouped(groom->report.segments).c_str(),
                timesLine(clock).c_str());
    return done;
}

}  // namespace

void addSettle(CLI::App& program, int& status) {
    const auto arguments = std::make_shared<SettleArguments>();
    CLI::App* command = program.add_subcommand("settle", "Bring a style's hair to rest and write its strands");
    command->add_option("STYLE", arguments->input, "The style file (.toml)")->required();
    command->add_option("-o,--output", arguments->output, "Where to: .hair, .ply or .obj (centimetres)")
        ->required();
    addSettleFlags(*command, arguments->flags);
    command->add_option("--report", arguments->reportPath, "Write counts, times and penetration as JSON");
    command->footer(
        "Example: kushi settle styles/fig10-bob.toml -o preview.ply --count 500\n"
        "settles an evenly spread 500 of the bob's hairs.");
    command->callback([arguments, &status] { status = run(*arguments); });
}

}  // namespace kushi
