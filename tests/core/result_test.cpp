// SPDX-License-Identifier: Apache-2.0
#include <kushi/result.h>

#include <gtest/gtest.h>

namespace kushi {
namespace {

TEST(Result, HoldsAValueOrProblems) {
    const Result<int> good = 3;
    ASSERT_TRUE(good);
    EXPECT_EQ(*good, 3);
    const Result<int> bad = Problem{"no"};
    ASSERT_FALSE(bad);
    EXPECT_EQ(bad.problems().at(0).message, "no");
}

TEST(Problem, ReadsLikeACompilersMessage) {
    EXPECT_EQ(toString(Problem{"too long", "bob.toml", 3, 7}), "bob.toml:3:7: error: too long");
    EXPECT_EQ(toString(Problem{"too long", "bob.toml", 3}), "bob.toml:3: error: too long");
    EXPECT_EQ(toString(Problem{"missing", "bob.toml"}), "bob.toml: error: missing");
    EXPECT_EQ(toString(Problem{"missing"}), "error: missing");
}

}  // namespace
}  // namespace kushi
