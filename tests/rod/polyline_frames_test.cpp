// SPDX-License-Identifier: Apache-2.0
#include "rod/polyline_frames.h"

#include <numbers>

#include <gtest/gtest.h>

namespace kushi {
namespace {

std::vector<Vec3d> circle(double radius, std::span<const double> angles) {
    std::vector<Vec3d> nodes;
    for (const double a : angles)
        nodes.push_back({radius * std::sin(a), 0, radius * (1 - std::cos(a))});
    return nodes;
}

TEST(PolylineFrames, TangentsOfAnUnevenlyCutCircleAreItsOwn) {
    const double angles[] = {0, 0.1, 0.15, 0.5, 0.6, 1.2};
    const std::vector<Vec3d> tangents = nodeTangents(circle(3, angles));
    for (std::size_t j = 0; j < tangents.size(); ++j) {
        const Vec3d own = {std::cos(angles[j]), 0, std::sin(angles[j])};
        EXPECT_LT(length(tangents[j] - own), 1e-12) << j;
    }
}

TEST(PolylineFrames, FramesFollowTheTangentsAndDoNotTwist) {
    std::vector<Vec3d> helix;
    for (int j = 0; j <= 30; ++j)
        helix.push_back({std::cos(0.4 * j), 0.2 * j, std::sin(0.4 * j)});
    const std::vector<Vec3d> tangents = nodeTangents(helix);
    const std::vector<Rotation> frames = framesAlong(tangents);
    for (std::size_t j = 0; j < frames.size(); ++j) {
        EXPECT_LT(length(rotate(frames[j], {0, 0, 1}) - tangents[j]), 1e-7);  // floats
        if (j == 0) continue;
        const Rotation step = inverse(frames[j - 1]) * frames[j];
        EXPECT_NEAR(step.v.z, 0, 1e-12);
        EXPECT_GT(step.w, 0);
    }
}

TEST(PolylineFrames, AHairpinTurnsByNoMoreThanTheSharpestPerSegment) {
    const std::vector<Vec3d> nodes = {{0, 0, 0}, {1, 0, 0}, {0, 0, 0}, {1, 0, 0}, {1, 1, 0}};
    const std::vector<Vec3d> tangents = nodeTangents(nodes);
    for (std::size_t j = 1; j < tangents.size(); ++j) {
        ASSERT_TRUE(isFinite(tangents[j]));
        EXPECT_NEAR(length(tangents[j]), 1, 1e-12);
        EXPECT_GE(dot(tangents[j - 1], tangents[j]), std::cos(sharpest) - 1e-9);
    }
}

TEST(PolylineFrames, OneSegmentIsItsOwnTangent) {
    const std::vector<Vec3d> nodes = {{0, 0, 0}, {0, -2, 0}};
    for (const Vec3d tangent : nodeTangents(nodes))
        EXPECT_EQ(tangent, (Vec3d{0, -1, 0}));
}

}  // namespace
}  // namespace kushi
