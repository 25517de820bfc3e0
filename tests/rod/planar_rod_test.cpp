// SPDX-License-Identifier: Apache-2.0
#include <kushi/planar_rod.h>

#include <algorithm>
#include <fstream>
#include <sstream>
#include <string>

#include <gtest/gtest.h>

namespace kushi {
namespace {

struct Reference {
    bool selfWeight;
    double clampDegrees, parameter, x, y, tipAngle;
};

std::vector<Reference> heavyElastica() {
    std::ifstream in(std::string(KUSHI_SOURCE_DIR) + "/tests/rod/heavy_elastica.csv");
    std::vector<Reference> rows;
    for (std::string line; std::getline(in, line);) {
        if (line.starts_with('#') || line.starts_with("load")) continue;
        std::replace(line.begin(), line.end(), ',', ' ');
        std::istringstream fields(line);
        std::string load;
        Reference row{};
        fields >> load >> row.clampDegrees >> row.parameter >> row.x >> row.y >> row.tipAngle;
        row.selfWeight = load == "self_weight";
        rows.push_back(row);
    }
    return rows;
}

PlanarRod rodFor(const Reference& row) {
    PlanarRod rod = {1, 1, 0, radians(row.clampDegrees), 0};
    (row.selfWeight ? rod.weight : rod.tipLoad) = row.parameter;
    return rod;
}

double tipError(const Reference& row, int segments) {
    const PlanarShape shape = bendPlanarRod(rodFor(row), segments, Method::Equilibrium);
    EXPECT_LT(shape.residual, 1e-9);
    return std::hypot(shape.nodes.back()[0] - row.x, shape.nodes.back()[1] - row.y);
}

TEST(PlanarEquilibrium, TipsAgreeWithTheHeavyElastica) {
    int rows = 0;
    for (const Reference& row : heavyElastica()) {
        if (row.clampDegrees > 80 || row.parameter > 1000) continue;
        const double error = tipError(row, 20);
        const bool level = row.clampDegrees == 0 && row.selfWeight;
        const double bound = level
                                 ? (row.parameter <= 10    ? 5e-4
                                    : row.parameter <= 100 ? 6e-4
                                                           : 2e-3)
                                 : (row.parameter <= 100 ? (row.selfWeight ? 4e-3 : 5e-3) : 1.2e-2);
        EXPECT_LT(error, bound) << row.selfWeight << ' ' << row.clampDegrees << ' '
                                << row.parameter;
        ++rows;
    }
    EXPECT_GT(rows, 60);
}

TEST(PlanarEquilibrium, IsOfSecondOrder) {
    for (const Reference& row : heavyElastica()) {
        if (row.parameter != 10 || row.clampDegrees > 60) continue;
        EXPECT_NEAR(tipError(row, 40) / tipError(row, 80), 4, 0.3) << row.clampDegrees;
    }
}

// An upright rod buckles under its own weight at w L^3 / EI = 7.8373 (Greenhill 1881).
TEST(PlanarEquilibrium, AnUprightRodBucklesWhereItShould) {
    PlanarRod rod = {1, 1, 7.70, radians(90), 0};
    EXPECT_NEAR(bendPlanarRod(rod, 50, Method::Equilibrium).nodes.back()[0], 0, 1e-3);
    rod.weight = 7.97;
    EXPECT_GT(bendPlanarRod(rod, 50, Method::Equilibrium).nodes.back()[0], 0.1);
}

TEST(PlanarCantilever, SaysHowFarItIsFromRest) {
    const PlanarRod level = {1, 1, 5, 0, 0};
    EXPECT_GT(bendPlanarRod(level, 20, Method::Cantilever).residual, 0.05);
    // One that hangs is at rest in both.
    const PlanarRod hanging = {1, 1, 5, radians(-90), 0};
    EXPECT_LT(bendPlanarRod(hanging, 20, Method::Cantilever).residual, 1e-9);
    EXPECT_NEAR(bendPlanarRod(hanging, 20, Method::Equilibrium).nodes.back()[1], -1, 1e-12);
}

}  // namespace
}  // namespace kushi
