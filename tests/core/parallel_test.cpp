// SPDX-License-Identifier: Apache-2.0
#include "core/parallel.h"

#include <atomic>
#include <mutex>
#include <set>
#include <vector>

#include <gtest/gtest.h>

namespace kushi {
namespace {

TEST(ParallelFor, VisitsEveryItemOnce) {
    for (const int threads : {0, 1, 2, 8}) {
        std::vector<std::atomic<int>> visits(1003);
        parallelFor(visits.size(), 10, threads, [&](std::size_t begin, std::size_t end) {
            for (std::size_t i = begin; i < end; ++i)
                ++visits[i];
        });
        for (const auto& visit : visits)
            EXPECT_EQ(visit, 1);
    }
}

TEST(ParallelFor, PiecesDoNotDependOnTheNumberOfThreads) {
    const auto pieces = [](int threads) {
        std::mutex mutex;
        std::set<std::pair<std::size_t, std::size_t>> seen;
        parallelFor(101, 25, threads, [&](std::size_t begin, std::size_t end) {
            const std::lock_guard lock(mutex);
            seen.emplace(begin, end);
        });
        return seen;
    };
    const std::set<std::pair<std::size_t, std::size_t>> expected = {
        {0, 25}, {25, 50}, {50, 75}, {75, 100}, {100, 101}};
    EXPECT_EQ(pieces(1), expected);
    EXPECT_EQ(pieces(8), expected);
}

TEST(ParallelFor, DoesNothingForNothing) {
    parallelFor(0, 8, 2, [](std::size_t, std::size_t) { FAIL(); });
}

}  // namespace
}  // namespace kushi
