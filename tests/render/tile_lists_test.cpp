// SPDX-License-Identifier: Apache-2.0
#include "render/tile_lists.h"

#include <gmock/gmock.h>

namespace kushi {
namespace {

// Item i touches the tiles that divide it, of tiles 0 (as 10) to 9: a list's members are known.
constexpr std::size_t sources = 1000;
constexpr std::size_t tiles = 10;

void enumerateMultiples(std::size_t begin, std::size_t end, const auto& emit) {
    for (std::size_t i = begin; i < end; ++i) {
        for (std::size_t tile = 0; tile < tiles; ++tile) {
            if (i % (tile == 0 ? 10 : tile) == 0) emit(tile, static_cast<std::uint32_t>(i));
        }
    }
}

std::vector<std::uint32_t> multiplesOf(std::uint32_t divisor) {
    std::vector<std::uint32_t> multiples;
    for (std::uint32_t i = 0; i < sources; i += divisor)
        multiples.push_back(i);
    return multiples;
}

TEST(TileLists, HoldEachTilesItemsInOrder) {
    const auto enumerate = [](std::size_t begin, std::size_t end, const auto& emit) {
        enumerateMultiples(begin, end, emit);
    };
    for (const int threads : {1, 2, 8}) {
        TileLists lists(sources, tiles, threads, enumerate);
        for (const TileRange range : {TileRange{0, 10}, {0, 1}, {3, 7}, {9, 10}}) {
            lists.fill(range, enumerate);
            for (std::size_t tile = range.begin; tile < range.end; ++tile) {
                const auto expected =
                    multiplesOf(tile == 0 ? 10 : static_cast<std::uint32_t>(tile));
                EXPECT_EQ(lists.count(tile), expected.size());
                EXPECT_THAT(lists.items(tile), ::testing::ElementsAreArray(expected));
            }
        }
    }
}

TEST(TileLists, MayBeEmpty) {
    const auto enumerate = [](std::size_t, std::size_t, const auto&) {};
    TileLists lists(0, 3, 2, enumerate);
    lists.fill({0, 3}, enumerate);
    EXPECT_EQ(lists.count(1), 0U);
    EXPECT_TRUE(lists.items(2).empty());
}

}  // namespace
}  // namespace kushi
