// SPDX-License-Identifier: Apache-2.0
#include "commands.h"

#include <kushi/planar_rod.h>

#include <cmath>
#include <cstdio>

#include <nlohmann/json.hpp>

namespace kushi {

int runRod(const RodArguments& arguments) {
    const PlanarRod rod = {arguments.lengthCm / 100, arguments.rigidity, arguments.weight,
                           radians(arguments.angle), arguments.tipLoad};
    const Method method =
        arguments.method == "equilibrium" ? Method::Equilibrium : Method::Cantilever;
    const PlanarShape shape = bendPlanarRod(rod, arguments.segments, method);
    if (arguments.json) {
        nlohmann::ordered_json json;
        json["unit"] = "m";
        json["method"] = arguments.method;
        json["nodes"] = shape.nodes;
        json["residual"] = shape.residual;
        std::printf("%s\n", json.dump().c_str());
        return Done;
    }
    const auto [x, y] = shape.nodes.back();
    std::printf("w L^3 / EI   %.4g\n", rod.weight * std::pow(rod.length, 3) / rod.rigidity);
    std::printf("tip          %.4f cm forward, %.4f cm up\n", 100 * x, 100 * y);
    std::printf("residual     %.2g of EI/L + w L^2/2 + P L\n", shape.residual);
    std::printf("nodes (cm)\n");
    for (const auto& [nodeX, nodeY] : shape.nodes)
        std::printf("  %9.4f %9.4f\n", 100 * nodeX, 100 * nodeY);
    return Done;
}

}  // namespace kushi
