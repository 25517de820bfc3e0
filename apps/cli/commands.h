// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstddef>
#include <cstdint>
#include <optional>
#include <string>
#include <vector>

namespace kushi {

/// Exit status of the program: Done; BadInput for bad usage or bad input, with nothing written;
/// Failure for anything else, such as an output that cannot be written.
enum ExitStatus { Done = 0, Failure = 1, BadInput = 2 };

/// The flags of every command that settles a style.
struct SettleFlags {
    std::optional<int> segments;
    std::optional<std::size_t> count;
    int threads = 0;
    std::string method;  ///< as given; empty: the style's
};

/// What `settle` may change of a groom made elsewhere.
struct GroomFlags {
    std::string gravity;  ///< as given, "X,Y,Z"
    std::string up;       ///< the axis, as given
    std::optional<double> weightScale, stiffnessScale, set;
    std::optional<double> unit;  ///< cm
    bool pushOut = false;
    std::string solids;  ///< a style; empty: the mannequin
};

/// What only `--engine path` heeds.
struct PathFlags {
    std::optional<int> samples, bounces;
    std::optional<float> noise;
    std::optional<std::uint64_t> seed;
};

struct SettleArguments {
    std::string input, output, reportPath;
    SettleFlags flags;
    GroomFlags groom;
};

struct CheckArguments {
    std::string input;
    bool penetration = false;
    std::string solids;  ///< of a groom: a style; empty: the mannequin
    int threads = 0;
};

/// The flags of every command that draws.
struct StrokeFlags {
    int supersample = 4;
    std::string stroke;  ///< empty: the look's
    double widen = 1;
};

struct RenderArguments {
    std::string input, output, reportPath;
    std::string size = "1024x1024";
    std::string view = "three-quarter";
    std::string zoom;  ///< as given
    std::string look = "natural";
    std::string layers;  ///< as given, separated by commas
    bool alpha = false;
    StrokeFlags stroke;
    std::string engine = "raster";
    PathFlags path;
    SettleFlags flags;
};

struct SheetArguments {
    std::vector<std::string> inputs;
    std::string output;
    std::string cell = "512x512";
    std::string views = "three-quarter";  ///< separated by slashes
    std::string look = "natural";
    StrokeFlags stroke;
    SettleFlags flags;
};

struct RodArguments {
    double lengthCm = 10;
    double rigidity = 6.06e-9;  ///< N m2, of a medium hair
    double weight = 5.72e-5;    ///< N/m, of a medium hair
    double angle = 0;           ///< degrees
    double tipLoad = 0;         ///< N
    int segments = 24;
    std::string method = "equilibrium";
    bool json = false;
};

struct BenchArguments {
    std::string style;  // empty: the built-in scenes
    bool growth = false;
    int runs = 7;
    int threads = 0;
    bool json = false;
};

// The commands; each returns the exit status.
int runCheck(const CheckArguments& arguments);
int runSettle(const SettleArguments& arguments);
int runRender(const RenderArguments& arguments);
int runSheet(const SheetArguments& arguments);
int runNew(const std::string& path);
int runConvert(const std::string& from, const std::string& to);
int runInfo(const std::string& path, bool json);
int runRod(const RodArguments& arguments);
int runBench(const BenchArguments& arguments);

}  // namespace kushi
