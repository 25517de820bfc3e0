// SPDX-License-Identifier: Apache-2.0
#include "trace/hair_point.h"

#include <gtest/gtest.h>

namespace kushi {
namespace {

TEST(HairPoint, CountsNothingBeforeLightIsOutOfTheHair) {
    const FibreModel<float> model(Fibre{});
    HairSpot spot;
    spot.axis = {1, 2, 3};
    spot.tangent = spot.segment = {0, 1, 0};
    spot.radius = 4e-5F;
    const HairPoint point(model, spot, {1, 0, 0}, Places::one(0), {1, 1, 1});
    EXPECT_EQ(point.leaving({0, 0, 1}).origin, spot.axis);
    EXPECT_FLOAT_EQ(point.leaving({0, 0, 1}).from, 4e-5F);
    EXPECT_FLOAT_EQ(point.leaving({0, 0.8F, -0.6F}).from, 4e-5F / 0.6F);
    EXPECT_FLOAT_EQ(point.leaving({0, -1, 0}).from, 20 * 4e-5F);
}

}  // namespace
}  // namespace kushi
