// SPDX-License-Identifier: Apache-2.0
#include "commands.h"

#include <csignal>
#include <cstdio>
#include <exception>

namespace {

constexpr const char* description =
    "Kushi makes hair: a short text file says where it grows, what it is made of, which forces comb it\n"
    "and where it is cut; every hair is an elastic rod, and what you get is the whole head at rest.";

constexpr const char* firstSteps =
    "First steps:\n"
    "  kushi render styles/fig10-bob.toml -o bob.png      a picture of a style\n"
    "  kushi settle styles/fig10-bob.toml -o bob.hair     its strands, for other programs\n"
    "  kushi check my-style.toml                          what is wrong with a style, and where\n"
    "  kushi COMMAND --help                               all about one command\n"
    "\n"
    "Styles are TOML (docs/style-file.md); grooms are .hair, .ply or .obj (docs/formats.md).";

int runProgram(int argc, char** argv) {
    CLI::App program(description, "kushi");
    program.set_version_flag("--version", "kushi " KUSHI_VERSION, "Print the version and stop");
    program.footer(firstSteps);
    program.require_subcommand(1);
    program.get_formatter()->column_width(34);

    int status = kushi::done;
    kushi::addCheck(program, status);
    kushi::addSettle(program, status);
    kushi::addRender(program, status);
    kushi::addConvert(program, status);
    kushi::addInfo(program, status);
    kushi::addRod(program, status);

    try {
        program.parse(argc, argv);
    } catch (const CLI::ParseError& error) {
        if (error.get_exit_code() == 0) return program.exit(error);  // --help and --version
        std::fprintf(stderr, "kushi: error: %s (see kushi --help)\n", error.what());
        return kushi::badInput;
    }
    return status;
}

}  // namespace

int main(int argc, char** argv) {
    // A full disk or a size limit is an error to report, not a signal to die from.
    std::signal(SIGXFSZ, SIG_IGN);
    try {
        return runProgram(argc, argv);
    } catch (const std::bad_alloc&) {
        std::fputs("kushi: error: out of memory; try fewer strands (--count) or segments\n", stderr);
    } catch (const std::exception& error) {
        std::fprintf(stderr, "kushi: error: %s\n", error.what());
    }
    return kushi::failure;
}
