// SPDX-License-Identifier: Apache-2.0
#include "render/near_first.h"

#include <algorithm>
#include <limits>
#include <random>

#include <gmock/gmock.h>

namespace kushi {
namespace {

TEST(NearFirst, PartsThingsByDistanceAndKeepsTheirOrder) {
    std::mt19937 random(1);
    std::uniform_real_distribution<float> inverse(0.1F, 2);
    std::vector<float> q(10000);
    NearFirst order;
    for (std::uint32_t i = 0; i < q.size(); ++i) {
        q[i] = inverse(random);
        order.add(i, q[i]);
    }
    order.sort();
    float before = std::numeric_limits<float>::max();
    std::size_t sum = 0;
    for (std::size_t i = 0; i < NearFirst::groups; ++i) {
        const auto group = order.group(i);
        EXPECT_TRUE(std::is_sorted(group.begin(), group.end()));
        EXPECT_GT(group.size(), q.size() / NearFirst::groups / 3);
        float least = before;
        for (const std::uint32_t thing : group) {
            EXPECT_LE(q[thing], before);
            least = std::min(least, q[thing]);
        }
        before = least;
        sum += group.size();
    }
    EXPECT_EQ(sum, q.size());
}

TEST(NearFirst, BearsFewAndEqualThings) {
    NearFirst order;
    order.sort();
    for (std::size_t i = 0; i < NearFirst::groups; ++i)
        EXPECT_TRUE(order.group(i).empty());
    order.add(5, 1);
    order.add(2, 1);
    order.sort();
    std::vector<std::uint32_t> all;
    for (std::size_t i = 0; i < NearFirst::groups; ++i)
        all.insert(all.end(), order.group(i).begin(), order.group(i).end());
    EXPECT_THAT(all, ::testing::ElementsAre(5, 2));
    order.clear();
    EXPECT_EQ(order.size(), 0U);
}

}  // namespace
}  // namespace kushi
