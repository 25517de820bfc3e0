// SPDX-License-Identifier: Apache-2.0
//
// Straight rods against the heavy elastica. The references in heavy_elastica.csv come from two
// solvers of the continuous equation, which agree to 1e-11.
#include "rod/kernel/newton-inl.h"
#include "rod/rest_rods.h"

#include <algorithm>
#include <fstream>
#include <numbers>
#include <sstream>

#include <gtest/gtest.h>

namespace kushi {
namespace {

namespace kernel = HWY_NAMESPACE;

using rest::addRod;
using rest::planarClamp;
using rest::settleBy;

struct Reference {
    std::string load;
    double clamp = 0, parameter = 0, x = 0, y = 0, tipAngle = 0;  // degrees
};

std::vector<Reference> references(const std::string& load) {
    std::ifstream in(std::string(KUSHI_SOURCE_DIR) + "/tests/rod/heavy_elastica.csv");
    std::vector<Reference> rows;
    for (std::string line; std::getline(in, line);) {
        std::replace(line.begin(), line.end(), ',', ' ');
        std::istringstream fields(line);
        Reference row;
        fields >> row.load >> row.clamp >> row.parameter >> row.x >> row.y >> row.tipAngle;
        if (row.load == load) rows.push_back(row);
    }
    return rows;
}

struct Error {
    double tip = 0;    // over L
    double angle = 0;  // degrees
};

// What the settled rods of these references are off.
std::vector<Error> errors(std::span<const Reference> rows, int segments, bool graded,
                          void (*settle)(const StrandBatch&), double tolerance) {
    Rods rods;
    for (const Reference& row : rows)
        addRod(rods, planarClamp(radians(row.clamp)), row.parameter, segments);
    if (graded) rest::grade(rods);
    const rest::Settled settled = settleBy(settle, rods, {}, tolerance);
    std::vector<Error> result;
    for (std::size_t i = 0; i < rows.size(); ++i) {
        EXPECT_EQ(settled.states[i], 1) << rows[i].clamp << ' ' << rows[i].parameter;
        const Vec3f tip = settled.tip(rods, i);
        const auto tangent = settled.turnsOf(i).last(3);
        EXPECT_NEAR(tip.z, 0, 1e-4) << "a rod bends in its plane";
        result.push_back(
            {std::hypot(tip.x - rows[i].x, tip.y - rows[i].y),
             std::abs(degrees(std::atan2(tangent[1], tangent[0])) - rows[i].tipAngle)});
    }
    return result;
}

// The element errs by (d / l)^2 with l = L / Gamma^(1/3), the length over which a rod bends.
double tipBound(const Reference& row) {
    const double gamma = row.parameter;
    if (row.clamp == 0) return gamma <= 10 ? 2e-4 : gamma <= 100 ? 6e-4 : 2e-3;
    return gamma <= 100 ? 4e-3 : 1.2e-2;
}

std::string name(const Reference& row) {
    return "clamp " + std::to_string(row.clamp) + ", Gamma " + std::to_string(row.parameter);
}

TEST(RestElastica, TipsAgreeWithTheContinuousRodAtEveryLoadAndClamp) {
    const auto rows = references("self_weight");
    ASSERT_EQ(rows.size(), 52U);
    const auto exact = errors(rows, 20, false, settleReference, 1e-9);
    const auto lanes = errors(rows, 20, false, settleLanes, 1e-5);
    for (std::size_t i = 0; i < rows.size(); ++i) {
        const double bound = tipBound(rows[i]);
        EXPECT_LT(exact[i].tip, bound) << name(rows[i]);
        // What the lanes' tolerance of 1e-5 leaves is a bend of that order.
        EXPECT_LT(lanes[i].tip, bound + 1e-4) << name(rows[i]);
        EXPECT_LT(exact[i].angle, 0.15) << name(rows[i]);
        EXPECT_LT(lanes[i].angle, 0.16) << name(rows[i]);
    }
}

TEST(RestElastica, SegmentsGradedToTheRootAreSeveralTimesBetterUnderHeavyLoads) {
    const auto rows = references("self_weight");
    const auto equal = errors(rows, 20, false, settleReference, 1e-9);
    const auto graded = errors(rows, 20, true, settleReference, 1e-9);
    for (std::size_t i = 0; i < rows.size(); ++i) {
        EXPECT_LT(graded[i].tip, 1.4e-3) << name(rows[i]);
        if (rows[i].parameter >= 100) {
            EXPECT_GT(equal[i].tip / graded[i].tip, 4) << name(rows[i]);
        }
        if (rows[i].parameter >= 10 && rows[i].clamp == 80) {
            EXPECT_GT(equal[i].tip / graded[i].tip, 2.4) << name(rows[i]);
        }
    }
}

TEST(RestElastica, IsOfSecondOrder) {
    std::vector<Reference> rows = references("self_weight");
    std::erase_if(rows, [](const Reference& r) { return r.parameter < 5 || r.parameter > 100; });
    const auto coarse = errors(rows, 40, false, settleReference, 1e-10);
    const auto fine = errors(rows, 80, false, settleReference, 1e-10);
    for (std::size_t i = 0; i < rows.size(); ++i)
        EXPECT_NEAR(coarse[i].tip / fine[i].tip, 4, 0.1) << name(rows[i]);
}

// Rods have no load at the tip, the kernel has.
TEST(RestElastica, TipLoadsAgreeWithTheContinuousRodToo) {
    using Element = kernel::Straight<double>;
    constexpr int n = 20;
    for (const Reference& row : references("tip_point_load")) {
        const double clamp = radians(row.clamp);
        const std::vector<Element::Segment> segments(n, {1.0 / n, 0, n});
        std::vector<kernel::Node<double, Element>> nodes(n + 1);
        for (auto& node : nodes)
            node.state = {std::cos(clamp), std::sin(clamp), 0};
        const auto straight = nodes;
        const kernel::Problem<double, Element> problem = {
            {0, 0, 0}, nodes[0].state,   segments, {0, -1, 0}, {0, -row.parameter, 0}, {}, {},
            {},        1 + row.parameter};
        kernel::Newton<double, Element> newton(problem, nodes, {});
        kernel::Progress<double> at{};
        // As the reference does: the second time in smaller steps.
        for (const double growth : {4.0, 1.25}) {
            nodes = straight;
            at = {};
            at.share = std::min(1.0, 1 / row.parameter);
            kernel::NewtonOptions options;
            options.tolerance = 1e-10;
            options.growth = growth;
            options.reach = 0.2 * growth;
            options.maxSteps = 1000;
            newton.run(options, at);
            if (at.settled) break;
        }
        newton.place();
        ASSERT_TRUE(at.settled) << name(row);
        // The whole load sits at the tip, so the bend near the root is sharper: L / sqrt(Pi).
        const double bound = row.parameter <= 100 ? 5e-3 : 1.2e-2;
        EXPECT_LT(std::hypot(nodes[n].position[0] - row.x, nodes[n].position[1] - row.y), bound)
            << name(row);
    }
}

// An upright rod buckles under its own weight at Gamma = 7.8373 (Greenhill 1881), and to the side
// that its key chooses.
TEST(RestElastica, UprightRodsBuckleWhereTheyShouldAndToBothSides) {
    for (const double gamma : {7.75, 8.0, 30.0}) {
        Rods rods;
        for (std::uint64_t key = 0; key < 400; ++key)
            addRod(rods, frameAlong({0, 1, 0}), gamma, 50, key);
        const rest::Settled settled = rest::settle(rods, {});
        Vec3d sum;
        int right = 0;
        for (std::size_t i = 0; i < rods.size(); ++i) {
            EXPECT_EQ(settled.states[i], 1);
            const Vec3d tip = settled.tip(rods, i).as<double>();
            const double aside = std::hypot(tip.x, tip.z);
            if (gamma < 7.83) {
                EXPECT_LT(aside, 0.03) << i;
            } else {
                EXPECT_GT(aside, 0.1) << i;
            }
            right += tip.x > 0 ? 1 : 0;
            sum += tip;
        }
        if (gamma < 7.83) continue;
        EXPECT_NEAR(right, 200, 60);  // six standard deviations
        EXPECT_LT(std::hypot(sum.x, sum.z) / 400, 0.1) << "no side is preferred";
    }
}

}  // namespace
}  // namespace kushi
