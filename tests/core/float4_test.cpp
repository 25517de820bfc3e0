// SPDX-License-Identifier: Apache-2.0
#include "core/float4.h"

#include <gtest/gtest.h>

namespace kushi {
namespace {

TEST(Float4, ExponentialIsThatOfTheLibrary) {
    for (float x = -79; x < 79; x += 0.37F) {
        const Float4 values = exponential(Float4{x, -x, 0.01F * x, x + 0.2F});
        EXPECT_NEAR(values[0] / std::exp(x), 1, 1e-6) << x;
        EXPECT_NEAR(values[1] / std::exp(-x), 1, 1e-6) << x;
        EXPECT_NEAR(values[2] / std::exp(0.01F * x), 1, 1e-6) << x;
        EXPECT_NEAR(values[3] / std::exp(x + 0.2F), 1, 1e-6) << x;
    }
    EXPECT_EQ(exponential(float4(0))[2], 1);
    EXPECT_EQ(exponential(float4(-1e9F))[0], exponential(float4(-80))[0]);
    EXPECT_EQ(exponential(float4(1e9F))[0], exponential(float4(80))[0]);
}

TEST(Float4, ArcCosineIsThatOfTheLibrary) {
    for (float x = -1; x <= 1; x += 0.01F)
        EXPECT_NEAR(arcCosine(float4(x))[1], std::acos(x), 7e-5) << x;
    EXPECT_EQ(arcCosine(float4(1))[0], 0);
}

}  // namespace
}  // namespace kushi
