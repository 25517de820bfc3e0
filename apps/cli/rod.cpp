// SPDX-License-Identifier: Apache-2.0
#include <cmath>
#include <cstdio>
#include <memory>

#include <nlohmann/json.hpp>

#include "commands.h"

#include <kushi/planar_rod.h>

namespace kushi {

namespace {

struct RodArguments {
    double lengthCm = 10, rigidity = 6.06e-9, weight = 5.72e-5, angle = 0, tipLoad = 0;
    int segments = 24;
    std::string method = "equilibrium";
    bool json = false;
};

int bendAndPrint(const RodArguments& arguments) {
    const PlanarRod rod = {arguments.lengthCm / 100, arguments.rigidity, arguments.weight,
                           radians(arguments.angle), arguments.tipLoad};
    const Method method = arguments.method == "equilibrium" ? Method::Equilibrium : Method::Cantilever;
    const PlanarShape shape = bendPlanarRod(rod, arguments.segments, method);
    if (arguments.json) {
        nlohmann::ordered_json json;
        json["unit"] = "m";
        json["method"] = arguments.method;
        json["nodes"] = shape.nodes;
        json["residual"] = shape.residual;
        std::printf("%s\n", json.dump().c_str());
        return done;
    }
    const auto [x, y] = shape.nodes.back();
    std::printf("w L^3 / EI   %.4g\n", rod.weight * std::pow(rod.length, 3) / rod.rigidity);
    std::printf("tip          %.4f cm forward, %.4f cm up\n", 100 * x, 100 * y);
    std::printf("residual     %.2g of EI/L + w L^2/2 + P L\n", shape.residual);
    std::printf("nodes (cm)\n");
    for (const auto& [nodeX, nodeY] : shape.nodes) std::printf("  %9.4f %9.4f\n", 100 * nodeX, 100 * nodeY);
    return done;
}

}  // namespace

void addRod(CLI::App& program, int& status) {
    const auto arguments = std::make_shared<RodArguments>();
    CLI::App* command = program.add_subcommand("rod", "Bend one clamped hair in its plane");
    const auto positive = CLI::Range(1e-12, 1e12);
    command->add_option("--length", arguments->lengthCm, "cm")->check(CLI::Range(1e-3, 1e4))->capture_default_str();
    command->add_option("--segments", arguments->segments)->check(CLI::Range(1, 100000))->capture_default_str();
    command->add_option("--rigidity", arguments->rigidity, "EI, N m2; the default is a hair of 75 micrometres")
        ->check(positive)
        ->capture_default_str();
    command->add_option("--weight", arguments->weight, "N per m")->check(CLI::Range(0.0, 1e12))->capture_default_str();
    command->add_option("--angle", arguments->angle, "Of the clamp above the horizontal, degrees")
        ->check(CLI::Range(-180.0, 180.0))
        ->capture_default_str();
    command->add_option("--tip-load", arguments->tipLoad, "N, hung on the tip")
        ->check(CLI::Range(0.0, 1e12))
        ->capture_default_str();
    command->add_option("--method", arguments->method, "equilibrium (true rest) or cantilever (the paper's walk)")
        ->check(CLI::IsMember({"equilibrium", "cantilever"}))
        ->capture_default_str();
    command->add_flag("--json", arguments->json, "Print JSON: unit, nodes as [x, y], residual");
    command->footer(
        "Examples:\n"
        "  kushi rod --length 10                        how far ten centimetres of hair hang\n"
        "  kushi rod --length 10 --method cantilever    the same by the walk of 1992\n"
        "  kushi rod --length 8 --angle 90              stands; at 10 it buckles");
    command->callback([arguments, &status] { status = bendAndPrint(*arguments); });
}

}  // namespace kushi
