// SPDX-License-Identifier: Apache-2.0
#include "core/random.h"

#include <cmath>

#include <gtest/gtest.h>

namespace kushi {
namespace {

// First output of SplitMix64 from state 0, a published reference value.
TEST(Random, ScrambleIsSplitMix64) {
    EXPECT_EQ(scramble(0), 0xe220a8397b1dcdafU);
}

// FNV-1a of "a" and of the empty text, published reference values.
TEST(Random, TextKeyIsFnv1a) {
    EXPECT_EQ(textKey(""), 0xcbf29ce484222325U);
    EXPECT_EQ(textKey("a"), 0xaf63dc4c8601ec8cU);
}

TEST(Random, UniformHasTheMomentsOfAUniformVariable) {
    constexpr int n = 100000;
    double sum = 0;
    double squares = 0;
    double products = 0;
    for (std::uint64_t i = 0; i < n; ++i) {
        const double u = uniformSigned(mixKey(7, i));
        ASSERT_GE(u, -1);
        ASSERT_LT(u, 1);
        sum += u;
        squares += u * u;
        products += u * uniformSigned(mixKey(8, i));
    }
    // Four standard errors: 1/sqrt(3 n), sqrt(4/45 n), 1/(3 sqrt n).
    EXPECT_NEAR(sum / n, 0, 4 / std::sqrt(3.0 * n));
    EXPECT_NEAR(squares / n, 1.0 / 3, 4 * std::sqrt(4.0 / 45 / n));
    EXPECT_NEAR(products / n, 0, 4 / (3 * std::sqrt(double{n})));
}

}  // namespace
}  // namespace kushi
