// SPDX-License-Identifier: Apache-2.0
#include "shading/tangents.h"

#include <limits>
#include <vector>

#include <gmock/gmock.h>

namespace kushi {
namespace {

std::vector<Vec3f> tangentsOf(const std::vector<Vec3f>& nodes) {
    std::vector<Vec3f> tangents(nodes.size(), {9, 9, 9});
    forEachTangent(nodes, [&](std::size_t i, Vec3f t) { tangents[i] = t; });
    for (std::size_t i = 0; i < nodes.size(); ++i) {
        const Vec3f alone = tangentAt(nodes, i);
        EXPECT_EQ(alone.x, tangents[i].x) << i;
        EXPECT_EQ(alone.y, tangents[i].y) << i;
        EXPECT_EQ(alone.z, tangents[i].z) << i;
    }
    return tangents;
}

void expectNear(Vec3f a, Vec3f b) {
    EXPECT_NEAR(a.x, b.x, 1e-6);
    EXPECT_NEAR(a.y, b.y, 1e-6);
    EXPECT_NEAR(a.z, b.z, 1e-6);
}

const float half = std::sqrt(0.5F);

TEST(Tangents, AreTheMeanOfTheSegmentsThatMeet) {
    // Unequal lengths: each direction counts once.
    const auto t = tangentsOf({{0, 0, 0}, {3, 0, 0}, {3, 0.5F, 0}, {3, 0.5F, 2}});
    expectNear(t[0], {1, 0, 0});
    expectNear(t[1], {half, half, 0});
    expectNear(t[2], {0, half, half});
    expectNear(t[3], {0, 0, 1});
}

TEST(Tangents, SkipSegmentsWithoutLength) {
    const auto t = tangentsOf({{0, 0, 0}, {0, 0, 0}, {1, 0, 0}, {1, 0, 0}, {1, 1, 0}, {1, 1, 0}});
    expectNear(t[0], {1, 0, 0});
    expectNear(t[1], {1, 0, 0});
    expectNear(t[2], {half, half, 0});
    expectNear(t[3], {half, half, 0});
    expectNear(t[4], {0, 1, 0});
    expectNear(t[5], {0, 1, 0});
}

TEST(Tangents, SkipNodesThatAreNotFinite) {
    const float nan = std::numeric_limits<float>::quiet_NaN();
    const auto t = tangentsOf({{0, 0, 0}, {1, 0, 0}, {nan, 0, 0}, {2, 0, 0}, {2, 1, 0}});
    expectNear(t[1], {half, half, 0});
    expectNear(t[3], {half, half, 0});
    expectNear(t[4], {0, 1, 0});
}

TEST(Tangents, LieAlongAFold) {
    const auto t = tangentsOf({{0, 0, 0}, {1, 0, 0}, {0, 0, 0}});
    expectNear(t[1], {1, 0, 0});
}

TEST(Tangents, AreZeroWithoutAnyLength) {
    for (const Vec3f t : tangentsOf({{1, 2, 3}, {1, 2, 3}}))
        expectNear(t, {});
    for (const Vec3f t : tangentsOf({{1, 2, 3}}))
        expectNear(t, {});
    EXPECT_TRUE(tangentsOf({}).empty());
}

}  // namespace
}  // namespace kushi
