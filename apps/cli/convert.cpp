// SPDX-License-Identifier: Apache-2.0
#include <cstdio>
#include <memory>

#include "commands.h"
#include "input.h"
#include "messages.h"

#include <kushi/groom_io.h>

namespace kushi {

namespace {

int convert(const std::string& from, const std::string& to) {
    if (const Status ending = hasEnding(to, {".hair", ".ply", ".obj"}, "the output"); !ending) {
        return report(ending.problems());
    }
    const Result<Strands> strands = readGroom(from);
    if (!strands) return report(strands.problems());
    if (const Status written = writeGroom(*strands, to); !written) return report(written.problems());
    std::printf("%s: %s strands, %s segments\n", to.c_str(), grouped(strands->size()).c_str(),
                grouped(strands->segmentCount()).c_str());
    return done;
}

}  // namespace

void addConvert(CLI::App& program, int& status) {
    struct Paths {
        std::string from, to;
    };
    const auto paths = std::make_shared<Paths>();
    CLI::App* command = program.add_subcommand("convert", "Turn one strand format into another");
    command->add_option("FROM", paths->from, "A groom: .hair, .ply or .obj")->required();
    command->add_option("TO", paths->to, "A groom: .hair, .ply or .obj")->required();
    command->footer("docs/formats.md says what each format keeps.");
    command->callback([paths, &status] { status = convert(paths->from, paths->to); });
}

}  // namespace kushi
