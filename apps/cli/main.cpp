// SPDX-License-Identifier: Apache-2.0
//
// The grammar of the command line, and nothing else.
#include "commands.h"

#include <array>
#include <csignal>
#include <cstdio>
#include <exception>
#include <new>

#include <CLI/CLI.hpp>

namespace kushi {

namespace {

constexpr const char* description =
    "Kushi makes hair: a short text file says where it grows, what it is made of, which forces "
    "comb it\n"
    "and where it is cut; every hair is an elastic rod, and what you get is the whole head at "
    "rest.";

constexpr const char* firstSteps =
    "First steps:\n"
    "  kushi new my-style.toml                            a commented style to begin with\n"
    "  kushi render styles/fig10-bob.toml -o bob.png      a picture of a style\n"
    "  kushi settle styles/fig10-bob.toml -o bob.hair     its strands, for other programs\n"
    "  kushi check my-style.toml                          what is wrong with a style, and where\n"
    "  kushi COMMAND --help                               all about one command\n"
    "\n"
    "Styles are TOML (docs/style-file.md); grooms are .hair, .ply or .obj (docs/formats.md).";

constexpr const char* styleOrGroom = "A style (.toml) or a groom (.hair, .ply, .obj)";

// CLI11's own Range lets "nan" through.
auto between(double least, double most) {
    return [least, most](const std::string& text) -> std::string {
        double value = 0;
        if (CLI::detail::lexical_cast(text, value) && value >= least && value <= most) return {};
        std::array<char, 128> message{};
        std::snprintf(message.data(), message.size(), "'%.40s' is not a number from %g to %g",
                      text.c_str(), least, most);
        return message.data();
    };
}

void addSettleFlags(CLI::App& command, SettleFlags& flags) {
    command
        .add_option("--count", flags.count,
                    "Strands: fewer are an evenly spread subset of the style's own")
        ->check(CLI::Range(1, 5000000));
    command.add_option("--segments", flags.segments, "Segments per strand")
        ->check(CLI::Range(1, 256));
    command
        .add_option("--method", flags.method,
                    "cantilever (the paper's walk) or equilibrium (true rest), instead of the "
                    "style's")
        ->check(CLI::IsMember({"cantilever", "equilibrium"}));
    command.add_option("--threads", flags.threads, "Threads (as many as the machine has)")
        ->check(CLI::Range(1, 1024));
}

void addStrokeFlags(CLI::App& command, StrokeFlags& flags) {
    command.add_option("--supersample", flags.supersample, "Samples per pixel along each axis")
        ->check(CLI::IsMember({1, 2, 4}))
        ->capture_default_str();
    command
        .add_option(
            "--stroke", flags.stroke,
            "sampled (strands as wide as they are), analytic (the same, softer and slower) or line "
            "(one sample wide, as in 1992; of the paper's look)")
        ->check(CLI::IsMember({"sampled", "analytic", "line"}));
    command
        .add_option("--widen", flags.widen,
                    "Times the width of strands, for sampled and analytic: k for every k-th strand")
        ->check(between(1e-3, 1e6))
        ->capture_default_str();
}

void addGroomFlags(CLI::App& command, GroomFlags& flags) {
    const auto scale = [&](const char* name, std::optional<double>& value, const char* what,
                           double least, double most) {
        command.add_option(name, value, what)->check(between(least, most));
    };
    command.add_option("--gravity", flags.gravity,
                       "Grooms: X,Y,Z, times the earth's, in the file's axes (down)");
    scale("--weight-scale", flags.weightScale, "Grooms: times the weight it was set with", 0.001,
          1000);
    scale("--stiffness-scale", flags.stiffnessScale, "Grooms: times the stiffness it was set with",
          0.001, 1000);
    scale("--set", flags.set, "Grooms: share of the natural shape that stays, 0 (straight) to 1", 0,
          1);
    command.add_option("--up", flags.up, "Grooms: the file's upward axis: x, y, z, -x, ... (y)");
    scale("--unit", flags.unit, "Grooms: the file's unit in centimetres (1)", 1e-4, 1e4);
    command.add_flag("--push-out", flags.pushOut,
                     "Grooms: turn strands out of the head, on which they then rest");
    command.add_option("--solids", flags.solids,
                       "Grooms: the same with the head and the colliders of a style");
}

// Every command's arguments, filled while parsing.
struct Arguments {
    std::string style, from, to, described;
    bool json = false;
    CheckArguments check;
    SettleArguments settle;
    RenderArguments render;
    SheetArguments sheet;
    RodArguments rod;
    BenchArguments bench;
};

void addCheck(CLI::App& program, CheckArguments& arguments, int& status) {
    CLI::App* command =
        program.add_subcommand("check", "Say what is wrong with a style, and where");
    command->add_option("STYLE|GROOM", arguments.input, styleOrGroom)->required();
    command->add_flag("--penetration", arguments.penetration,
                      "Settle the style and say how far hair is inside of head and colliders; of a "
                      "groom it is always said");
    command->add_option("--solids", arguments.solids,
                        "Grooms: a style whose head and colliders count (the mannequin)");
    command->add_option("--threads", arguments.threads, "Threads (as many as the machine has)")
        ->check(CLI::Range(1, 1024));
    command->footer(
        "Every problem is one line, FILE:LINE:COLUMN: error: ...; exit status 2 if there are any.\n"
        "Penetration is measured at 8 points a segment, against the distance field.");
    command->callback([&] { status = runCheck(arguments); });
}

void addSettle(CLI::App& program, SettleArguments& arguments, int& status) {
    CLI::App* command =
        program.add_subcommand("settle", "Bring hair to rest and write its strands");
    command->add_option("STYLE|GROOM", arguments.input, styleOrGroom)->required();
    command
        ->add_option("-o,--output", arguments.output, "Where to: .hair, .ply or .obj (centimetres)")
        ->required();
    addSettleFlags(*command, arguments.flags);
    addGroomFlags(*command, arguments.groom);
    command->add_option("--report", arguments.reportPath,
                        "Write counts, times and penetration as JSON");
    command->footer(
        "A groom made elsewhere is set: it rests as it is, of medium hair or as thick as it says;\n"
        "then what the flags for grooms say is changed.\n"
        "Examples:\n"
        "  kushi settle styles/fig10-bob.toml -o preview.ply --count 500\n"
        "  kushi settle scan.hair -o headstand.hair --gravity 0,1,0\n"
        "  kushi settle scan.hair -o wet.hair --weight-scale 1.5 --set 0.5\n"
        "  kushi settle scan.hair -o clean.hair --push-out --solids actor.toml");
    command->callback([&] { status = runSettle(arguments); });
}

void addEngineFlags(CLI::App& command, RenderArguments& arguments) {
    command
        .add_option("--engine", arguments.engine,
                    "raster (at once) or path (light followed through every hair, in minutes)")
        ->check(CLI::IsMember({"raster", "path"}))
        ->capture_default_str();
    command.add_option("--spp", arguments.path.samples, "Path: samples per pixel (64)")
        ->check(CLI::Range(1, 65536));
    command
        .add_option("--bounces", arguments.path.bounces,
                    "Path: how often light is scattered at most (64)")
        ->check(CLI::Range(0, 10000));
    command
        .add_option("--noise", arguments.path.noise,
                    "Path: leave parts whose noise is below this share of their brightness, such "
                    "as 0.02")
        ->check(between(0, 1));
    command.add_option("--seed", arguments.path.seed, "Path: of chance (0)");
}

void addLook(CLI::App& command, std::string& look) {
    command
        .add_option("--look", look,
                    "natural: fibres in their own shadow; paper: as in 1992, lines without shadow")
        ->check(CLI::IsMember({"natural", "paper"}))
        ->capture_default_str();
}

void addRender(CLI::App& program, RenderArguments& arguments, int& status) {
    CLI::App* command = program.add_subcommand("render", "Draw a style or a groom");
    command->add_option("STYLE|GROOM", arguments.input, styleOrGroom)->required();
    command->add_option("-o,--output", arguments.output, "The picture (.png or .exr)")->required();
    command->add_option("--layers", arguments.layers,
                        "For .exr: some of depth,tangent,id,mask beside the picture");
    command->add_flag("--alpha", arguments.alpha,
                      "For .png: a transparent background, as .exr always has");
    command->add_option("--size", arguments.size, "WIDTHxHEIGHT in pixels")->capture_default_str();
    addStrokeFlags(*command, arguments.stroke);
    command
        ->add_option(
            "--view", arguments.view,
            "front, back, left, right, top, three-quarter, or YAW,PITCH in degrees (left: from the "
            "person's left)")
        ->capture_default_str();
    command->add_option("--zoom", arguments.zoom,
                        "TIMES,X,Y: so many times as large, about a place of the picture, 0 to 1 "
                        "from its left and top");
    addLook(*command, arguments.look);
    addEngineFlags(*command, arguments);
    addSettleFlags(*command, arguments.flags);
    command->add_option("--report", arguments.reportPath,
                        "Write counts, times and the share of scalp that shows as JSON");
    command->footer(
        "Examples:\n"
        "  kushi render styles/fig10-bob.toml -o bob.png --view front\n"
        "  kushi render scan.hair -o scan.png --view 30,15 --size 1920x1080\n"
        "  kushi render styles/fig10-bob.toml -o bob.exr --layers depth,tangent,id,mask\n"
        "  kushi render styles/fig10-bob.toml -o still.png --engine path --spp 256");
    command->callback([&] { status = runRender(arguments); });
}

void addSheet(CLI::App& program, SheetArguments& arguments, int& status) {
    CLI::App* command =
        program.add_subcommand("sheet", "Draw several styles, or one from several sides, in one");
    command->add_option("STYLE|GROOM...", arguments.inputs, "Styles and grooms")->required();
    command->add_option("-o,--output", arguments.output, "The sheet (.png)")->required();
    command
        ->add_option("--views", arguments.views,
                     "As for render, with slashes between: front/left/30,10")
        ->capture_default_str();
    command->add_option("--cell", arguments.cell, "WIDTHxHEIGHT of each picture in pixels")
        ->capture_default_str();
    addStrokeFlags(*command, arguments.stroke);
    addLook(*command, arguments.look);
    addSettleFlags(*command, arguments.flags);
    command->footer(
        "One view of each makes a block, several make a row for each style.\n"
        "Examples:\n"
        "  kushi sheet styles/*.toml -o styles.png\n"
        "  kushi sheet styles/fig10-bob.toml -o bob.png --views front/right/back/left");
    command->callback([&] { status = runSheet(arguments); });
}

void addNew(CLI::App& program, Arguments& arguments, int& status) {
    CLI::App* command = program.add_subcommand("new", "Write a commented style to begin with");
    command->add_option("STYLE", arguments.style, "The file to write (.toml); must not exist yet")
        ->required();
    command->footer("Example: kushi new mine.toml && kushi render mine.toml -o mine.png");
    command->callback([&] { status = runNew(arguments.style); });
}

void addConvert(CLI::App& program, Arguments& arguments, int& status) {
    CLI::App* command = program.add_subcommand("convert", "Turn one strand format into another");
    command->add_option("FROM", arguments.from, "A groom: .hair, .ply or .obj")->required();
    command->add_option("TO", arguments.to, "A groom: .hair, .ply or .obj")->required();
    command->footer("docs/formats.md says what each format keeps.");
    command->callback([&] { status = runConvert(arguments.from, arguments.to); });
}

void addInfo(CLI::App& program, Arguments& arguments, int& status) {
    CLI::App* command =
        program.add_subcommand("info", "Count and measure the strands of a style or groom");
    command->add_option("STYLE|GROOM", arguments.described, styleOrGroom)->required();
    command->add_flag("--json", arguments.json, "Print JSON");
    command->callback([&] { status = runInfo(arguments.described, arguments.json); });
}

void addRod(CLI::App& program, RodArguments& arguments, int& status) {
    CLI::App* command = program.add_subcommand("rod", "Bend one clamped hair in its plane");
    const auto number = [&](const char* name, double& value, const char* what, double least,
                            double most) {
        command->add_option(name, value, what)->check(between(least, most))->capture_default_str();
    };
    number("--length", arguments.lengthCm, "cm", 1e-3, 1e4);
    command->add_option("--segments", arguments.segments)
        ->check(CLI::Range(1, 100000))
        ->capture_default_str();
    number("--rigidity", arguments.rigidity, "EI, N m2; the default is a hair of 75 micrometres",
           1e-15, 1e12);
    number("--weight", arguments.weight, "N per m", 0, 1e12);
    number("--angle", arguments.angle, "Of the clamp above the horizontal, degrees", -180, 180);
    number("--tip-load", arguments.tipLoad, "N, hung on the tip", 0, 1e12);
    command
        ->add_option("--method", arguments.method,
                     "equilibrium (true rest) or cantilever (the paper's walk)")
        ->check(CLI::IsMember({"equilibrium", "cantilever"}))
        ->capture_default_str();
    command->add_flag("--json", arguments.json, "Print JSON: unit, nodes as [x, y], residual");
    command->footer(
        "Examples:\n"
        "  kushi rod --length 10                        how far ten centimetres of hair hang\n"
        "  kushi rod --length 10 --method cantilever    the same by the walk of 1992\n"
        "  kushi rod --length 8 --angle 90              stands; at 10 it buckles");
    command->callback([&] { status = runRod(arguments); });
}

void addBench(CLI::App& program, BenchArguments& arguments, int& status) {
    CLI::App* command = program.add_subcommand("bench", "Time the solvers on 50,000 strands");
    CLI::Option* style = command->add_option(
        "style", arguments.style, "A style, to be brought to true rest; else the built-in scenes");
    command
        ->add_flag("--growth", arguments.growth,
                   "How time grows, to 150,000 strands of 64 segments")
        ->excludes(style);
    command->add_option("--runs", arguments.runs, "Of each; the median counts")
        ->check(CLI::Range(1, 1000))
        ->capture_default_str();
    command->add_option("--threads", arguments.threads, "0: as many as the machine has")
        ->check(CLI::Range(0, 1024));
    command->add_flag("--json", arguments.json,
                      "Print JSON: name, strands, segments, threads, median_ms, runs");
    command->footer("docs/command-line.md says what is timed.");
    command->callback([&] { status = runBench(arguments); });
}

// What is wrong with the first word, if it is to be a command and is none.
std::string checkCommand(const CLI::App& program, int argc, char** argv) {
    std::string names;
    for (const CLI::App* command : program.get_subcommands(nullptr)) {
        if (argc > 1 && command->get_name() == argv[1]) return {};
        names += (names.empty() ? "" : ", ") + command->get_name();
    }
    if (argc < 2) return "say what to do: " + names;
    if (argv[1][0] == '-') return {};
    return "there is no command '" + std::string(argv[1]) + "'; there are " + names;
}

int runProgram(int argc, char** argv) {
    CLI::App program(description, "kushi");
    program.set_version_flag("--version", "kushi " KUSHI_VERSION, "Print the version and stop");
    program.footer(firstSteps);
    program.require_subcommand(1);
    program.get_formatter()->column_width(34);

    int status = Done;
    Arguments arguments;
    addNew(program, arguments, status);
    addCheck(program, arguments.check, status);
    addSettle(program, arguments.settle, status);
    addRender(program, arguments.render, status);
    addSheet(program, arguments.sheet, status);
    addConvert(program, arguments, status);
    addInfo(program, arguments, status);
    addRod(program, arguments.rod, status);
    addBench(program, arguments.bench, status);

    if (const std::string wrong = checkCommand(program, argc, argv); !wrong.empty()) {
        std::fprintf(stderr, "kushi: error: %s (see kushi --help)\n", wrong.c_str());
        return BadInput;
    }
    try {
        program.parse(argc, argv);
    } catch (const CLI::ParseError& error) {
        if (error.get_exit_code() == 0) return program.exit(error);  // --help and --version
        const std::string command = argv[1][0] == '-' ? "" : std::string(argv[1]) + ' ';
        std::fprintf(stderr, "kushi: error: %s (see kushi %s--help)\n", error.what(),
                     command.c_str());
        return BadInput;
    }
    return status;
}

}  // namespace

}  // namespace kushi

int main(int argc, char** argv) {
    // A full disk or a size limit is an error to report, not a signal to die from.
    std::signal(SIGXFSZ, SIG_IGN);
    try {
        const int status = kushi::runProgram(argc, argv);
        if (std::fflush(stdout) == 0 && std::ferror(stdout) == 0) return status;
        std::fputs("kushi: error: standard output could not be written\n", stderr);
    } catch (const std::bad_alloc&) {
        std::fputs(
            "kushi: error: out of memory; try fewer strands (--count), segments or pixels "
            "(--size)\n",
            stderr);
    } catch (const std::exception& error) {
        std::fprintf(stderr, "kushi: error: %s\n", error.what());
    }
    return kushi::Failure;
}
