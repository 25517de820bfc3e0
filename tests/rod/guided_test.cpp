// SPDX-License-Identifier: Apache-2.0
#include "rod/guided.h"

#include "rod/rest_rods.h"

#include <numeric>

#include <gtest/gtest.h>

namespace kushi {
namespace {

// Rods of unit length whose roots lie all over a square.
Rods meadow(int count, double side) {
    Rods rods;
    for (int i = 0; i < count; ++i) {
        const auto key = static_cast<std::uint64_t>(i);
        rest::addRod(rods, {}, 1, 4, key);
        rods.roots.back() = Vec3d{side * uniformSigned(mixKey(key, 1)) / 2,
                                  side * uniformSigned(mixKey(key, 2)) / 2, 0}
                                .as<float>();
    }
    return rods;
}

TEST(Guided, EveryStrandComesOnceAndAfterTwoThatAreNear) {
    for (const int count : {1, 2, 9, 500}) {
        const Rods rods = meadow(count, 0.5);
        std::vector<std::uint32_t> all(rods.size());
        std::iota(all.begin(), all.end(), 0U);
        StrandBatch batch;
        batch.rods = &rods;
        batch.strands = all;

        Guided order(batch, all);
        std::vector<int> come(rods.size());
        std::vector<std::uint32_t> done = order.guides();
        for (const std::uint32_t guide : done)
            ++come[guide];
        for (std::size_t next = 0; next < done.size(); ++next) {
            order.release(done[next], [&](const Guided::Between& three) {
                EXPECT_EQ(come[three.one], 1);
                EXPECT_EQ(come[three.other], 1);
                EXPECT_LE(rest::distance(rods.roots[three.one], rods.roots[three.other]), 0.1);
                EXPECT_LE(rest::distance(rods.roots[three.one], rods.roots[three.place]), 0.1);
                ++come[three.place];
                done.push_back(three.place);
            });
        }
        EXPECT_EQ(come, std::vector<int>(rods.size(), 1)) << count;
    }
}

TEST(Guided, MostOfThickHairIsGuidedAndNoneOfHairFarApart) {
    std::vector<std::uint32_t> all(800);
    std::iota(all.begin(), all.end(), 0U);
    StrandBatch batch;
    batch.strands = all;
    const Rods thick = meadow(800, 0.3);
    batch.rods = &thick;
    EXPECT_LT(Guided(batch, all).guides().size(), 200U);
    const Rods thin = meadow(800, 30);
    batch.rods = &thin;
    EXPECT_GT(Guided(batch, all).guides().size(), 790U);
}

}  // namespace
}  // namespace kushi
