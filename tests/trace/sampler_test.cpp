// SPDX-License-Identifier: Apache-2.0
#include "trace/sampler.h"

#include <cmath>
#include <vector>

#include <gtest/gtest.h>

namespace kushi {
namespace {

TEST(Sampler, SpreadsPowersOfTwoEvenlyOverTheSquare) {
    for (const std::uint64_t pixel : {0U, 1U, 77U}) {
        for (const int dimension : {0, 1, 5}) {
            for (const unsigned log : {2U, 4U, 8U}) {
                const std::uint32_t count = 1U << log;
                // In each way to cut the square into `count` equal boxes, one sample in each; the
                // second `count` samples too.
                for (unsigned across = 0; across <= log; ++across) {
                    for (const std::uint32_t from : {0U, count}) {
                        std::vector<int> boxes(count);
                        for (std::uint32_t i = 0; i < count; ++i) {
                            Sampler sampler(pixel, from + i);
                            for (int d = 0; d < dimension; ++d)
                                sampler.pair();
                            const Pair pair = sampler.pair();
                            const auto x = static_cast<std::uint32_t>(
                                std::ldexp(pair.u, static_cast<int>(across)));
                            const auto y = static_cast<std::uint32_t>(
                                std::ldexp(pair.v, static_cast<int>(log - across)));
                            ++boxes[(y << across) + x];
                        }
                        for (const int inBox : boxes)
                            ASSERT_EQ(inBox, 1) << log << " " << across;
                    }
                }
            }
        }
    }
}

TEST(Sampler, GivesEachPixelAndEachDimensionItsOwnNumbers) {
    double product = 0;
    double mean = 0;
    constexpr int count = 4096;
    for (int i = 0; i < count; ++i) {
        Sampler one(static_cast<std::uint64_t>(i), 3);
        const Pair first = one.pair();
        const Pair second = one.pair();
        product += (first.u - 0.5) * (second.u - 0.5) / count;
        mean += static_cast<double>(one.single()) / count;
    }
    EXPECT_NEAR(product, 0, 4.0 / 12 / std::sqrt(count));
    EXPECT_NEAR(mean, 0.5, 4 * std::sqrt(1.0 / 12 / count));
}

}  // namespace
}  // namespace kushi
