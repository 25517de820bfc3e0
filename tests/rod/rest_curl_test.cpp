// SPDX-License-Identifier: Apache-2.0
//
// Rods with natural curvature against the continuous Kirchhoff equations.
#include "rod/rest_rods.h"

#include <algorithm>
#include <numbers>

#include <gtest/gtest.h>

namespace kushi {
namespace {

using rest::addRod;
using rest::planarClamp;
using rest::settleBy;

// Tips of curls of unit length with EI = 1 and GJ = 2/3, of the boundary value problem by
// collocation (tolerance 1e-10), and how far our element ends from them: the error of its second
// order, as another program with the same element measured it.
struct Curl {
    double gamma, clamp;  // rad above the horizontal
    Vec3d curvature, tip;
    int segments[3] = {10, 25, 80};
    double error[3];
};
const Curl curls[] = {
    {10,
     0,
     {6, 0, 2},
     {-0.119585287, 0.108399111, -0.086492037},
     {10, 25, 80},
     {1.1e-2, 1.7e-3, 1.7e-4}},
    {50,
     radians(-90),
     {10, 0, 3},
     {0.200561092, -0.502894815, -0.125420463},
     {10, 25, 80},
     {2.2e-2, 3.6e-3, 3.5e-4}},
    {50,
     0.3,
     {12, 5, 6},
     {-0.206653145, -0.284380265, 0.111596325},
     {10, 25, 80},
     {1.1e-1, 1.7e-2, 1.6e-3}},
};

double tipError(const Curl& one, int segments, void (*kernel)(const StrandBatch&),
                double tolerance) {
    Rods rods;
    addRod(rods, planarClamp(one.clamp), one.gamma, segments);
    rest::curl(rods, one.curvature);
    const rest::Settled settled = settleBy(kernel, rods, {}, tolerance);
    EXPECT_EQ(settled.states[0], 1);
    return length(settled.tip(rods, 0).as<double>() - one.tip);
}

TEST(RestCurl, TipsAgreeWithTheContinuousRod) {
    for (const Curl& one : curls) {
        for (int i = 0; i < 3; ++i) {
            const double exact = tipError(one, one.segments[i], settleReference, 1e-8);
            const double lanes = tipError(one, one.segments[i], settleLanes, 1e-5);
            // The measured errors have two digits.
            EXPECT_NEAR(exact / one.error[i], 1, 0.05) << one.gamma << ' ' << one.segments[i];
            EXPECT_NEAR(lanes, exact, 3e-4) << one.gamma << ' ' << one.segments[i];
        }
    }
}

// Without loads nothing moves: a helix of radius r and pitch p (per turn) has the curvature
// r / (r^2 + h^2) and the torsion h / (r^2 + h^2), with h = p / 2 pi.
TEST(RestCurl, AnUnloadedHelixKeepsItsRadiusAndPitch) {
    const double r = 0.05;
    const double h = 0.08 / (2 * std::numbers::pi);
    const double scale = 1 / (r * r + h * h);
    for (const int segments : {12, 25, 100}) {
        Rods rods;
        addRod(rods, frameAlong(normalized(Vec3d{1, 2, 3})), 0, segments);
        rest::curl(rods, {r * scale, 0, h * scale});
        for (const rest::Settled& settled :
             {settleBy(settleReference, rods, {}, 1e-8), rest::settle(rods, {})}) {
            ASSERT_EQ(settled.states[0], 1);
            // On a helix every chord over k segments is as long as every other, by its turn.
            for (int k = 1; k <= 5; ++k) {
                const double turn = k * std::sqrt(scale) / segments;
                const double chord = std::hypot(2 * r * std::sin(0.5 * turn), h * turn);
                for (int j = 0; j + k <= segments; ++j) {
                    EXPECT_NEAR(rest::distance(settled.nodes[static_cast<std::size_t>(j)],
                                               settled.nodes[static_cast<std::size_t>(j + k)]),
                                chord, 1e-5)
                        << segments << ' ' << j << ' ' << k;
                }
            }
        }
    }
}

// A rod with the planar natural curvature k that hangs from a clamp pointing down stays in its
// plane above a load, and winds out of it below: w L^3 / EI = 474.514 for k L = 4 pi and GJ / EI =
// 2/3 (the Bend-Twist test of Romero et al. 2021; boundary by the second variation of the planar
// state, a spectral Galerkin method converged to seven digits).
double outOfPlane(double gamma, int segments) {
    Rods rods;
    addRod(rods, planarClamp(radians(-90)), gamma, segments, 5);
    // About d2 = z: the curl lies in the x-y plane.
    rest::curl(rods, {0, 4 * std::numbers::pi, 0});
    const rest::Settled settled = settleBy(settleReference, rods, {}, 1e-7);
    EXPECT_EQ(settled.states[0], 1) << gamma;
    double largest = 0;
    for (const Vec3f& node : settled.nodes)
        largest = std::max(largest, std::abs(static_cast<double>(node.z)));
    return largest;
}

// The frames at rest are where a solve begins that has nothing left to do; of strands of several
// sizes, so that they are not in order.
TEST(RestCurl, ARodThatStartsWhereItRestsStaysThere) {
    Rods rods;
    for (const int segments : {24, 9, 24, 17, 9}) {
        addRod(rods, frameAlong(normalized(Vec3d{1, 0.2, 0.1 * segments})), 30, segments);
        rest::curl(rods, {6, 0.2 * segments, 2});
    }
    RodWorld world;
    RestState state;
    std::vector<Vec3f> nodes(rods.nodeCount());
    EXPECT_TRUE(settleRods(rods, world, state, nodes).unsettled.empty());
    rods.starts = framesAtRest(rods, state);
    ASSERT_EQ(rods.starts.size(), rods.offsets.back());
    std::vector<Vec3f> again(rods.nodeCount());
    RestState anew;
    RestOptions nothing;
    nothing.tolerance = 0.01;  // any other start would be left at once
    EXPECT_TRUE(settleRods(rods, world, anew, again, nothing).unsettled.empty());
    for (std::size_t i = 0; i < rods.size(); ++i)
        EXPECT_LT(rest::gap(rods, i, nodes, again), 1e-4) << i;
}

TEST(RestCurl, ACurlLeavesItsPlaneAtTheBendTwistBoundary) {
    for (const auto& [segments, tolerance] : {std::pair{25, 0.02}, std::pair{80, 0.003}}) {
        double low = 300;
        double high = 700;
        EXPECT_GT(outOfPlane(low, segments), 0.02);
        EXPECT_LT(outOfPlane(high, segments), 1e-3);
        while (high - low > 0.2) {
            const double middle = 0.5 * (low + high);
            (outOfPlane(middle, segments) > 1e-3 ? low : high) = middle;
        }
        EXPECT_NEAR(low / 474.5143, 1, tolerance) << segments;
    }
}

}  // namespace
}  // namespace kushi
