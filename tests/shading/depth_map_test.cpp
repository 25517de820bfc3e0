// SPDX-License-Identifier: Apache-2.0
#include "shading/depth_map.h"

#include <limits>

#include <gtest/gtest.h>

namespace kushi {
namespace {

constexpr float slack = 0.004F;

/// 20 cm square, level, at a height of 10 cm.
Mesh plate() {
    Mesh mesh;
    mesh.vertices = {
        {-0.1F, 0.1F, -0.1F}, {0.1F, 0.1F, -0.1F}, {0.1F, 0.1F, 0.1F}, {-0.1F, 0.1F, 0.1F}};
    mesh.triangles = {{0, 1, 2}, {0, 2, 3}};
    return mesh;
}

TEST(DepthMap, HidesWhatLiesBehind) {
    const DepthMap map(plate(), {0, 1, 0}, 0.003F);
    EXPECT_EQ(map.lit({0, 0, 0}, slack), 0);
    EXPECT_EQ(map.lit({0.05F, 0.05F, -0.08F}, slack), 0);
    EXPECT_EQ(map.lit({0, 0.2F, 0}, slack), 1);
    EXPECT_EQ(map.lit({0.13F, 0, 0}, slack), 1);
    EXPECT_EQ(map.lit({5, 0, 0}, slack), 1);
}

TEST(DepthMap, SkinMayLieALittleBehindItself) {
    const DepthMap map(plate(), {0, 1, 0}, 0.003F);
    EXPECT_EQ(map.lit({0, 0.1F, 0}, slack), 1);
    EXPECT_EQ(map.lit({0, 0.1F - 0.9F * slack, 0}, slack), 1);
    EXPECT_NEAR(map.lit({0, 0.1F - 2 * slack, 0}, slack), 0.5, 1e-3);
    EXPECT_EQ(map.lit({0, 0.1F - 3.1F * slack, 0}, slack), 0);
}

TEST(DepthMap, ThrowsItsShadowAlongTheLight) {
    const DepthMap map(plate(), {0.6F, 0.8F, 0}, 0.003F);
    // 10 cm below the plate the shadow has moved by 7.5 cm.
    EXPECT_EQ(map.lit({-0.16F, 0, 0}, slack), 0);
    EXPECT_EQ(map.lit({0.01F, 0, 0}, slack), 0);
    EXPECT_EQ(map.lit({0.04F, 0, 0}, slack), 1);
}

TEST(DepthMap, OfNothingHidesNothing) {
    EXPECT_EQ(DepthMap().lit({0, 0, 0}, slack), 1);
    EXPECT_EQ(DepthMap(Mesh(), {0, 1, 0}, 0.003F).lit({0, 0, 0}, slack), 1);
    const float nan = std::numeric_limits<float>::quiet_NaN();
    EXPECT_EQ(DepthMap(plate(), {0, 1, 0}, 0.003F).lit({nan, nan, nan}, slack), 1);
}

}  // namespace
}  // namespace kushi
