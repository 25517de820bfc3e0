// SPDX-License-Identifier: Apache-2.0
#include "cli/program.h"

#include <cmath>

#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

namespace kushi::test {
namespace {

using nlohmann::json;

json rod(const std::string& arguments) {
    const Outcome run = runKushi("rod --json " + arguments);
    EXPECT_EQ(run.status, 0) << run.err;
    return json::parse(run.out);
}

// A stiff beam's tip drops by w L^4 / (8 EI) + P L^3 / (3 EI).
TEST(RodCommand, AStiffRodIsABeam) {
    const json bent =
        rod("--length 10 --segments 100 --rigidity 1e-3 --weight 0.01 --angle 0 --tip-load 1e-3");
    EXPECT_EQ(bent["unit"], "m");
    ASSERT_EQ(bent["nodes"].size(), 101U);
    EXPECT_EQ(bent["nodes"][0][0], 0);
    EXPECT_EQ(bent["nodes"][0][1], 0);
    const double drop = 0.01 * 1e-4 / 8e-3 + 1e-3 * 1e-3 / 3e-3;
    EXPECT_NEAR(-bent["nodes"][100][1].get<double>() / drop, 1, 1e-3);
    EXPECT_LT(bent["residual"], 1e-9);
}

TEST(RodCommand, TheCantileverBendsHalfAsFar) {
    const json bent =
        rod("--length 10 --segments 400 --rigidity 1e-3 --weight 0.01 --method cantilever");
    EXPECT_NEAR(-bent["nodes"][400][1].get<double>() / (0.01 * 1e-4 / 16e-3), 1, 0.01);
    EXPECT_GT(bent["residual"], 1e-4);
}

TEST(RodCommand, AngleIsAboveTheHorizontal) {
    const json up = rod("--length 10 --rigidity 1 --weight 1e-6 --angle 30 --segments 10");
    EXPECT_NEAR(up["nodes"][10][0], 0.1 * std::cos(M_PI / 6), 1e-6);
    EXPECT_NEAR(up["nodes"][10][1], 0.05, 1e-6);
}

}  // namespace
}  // namespace kushi::test
