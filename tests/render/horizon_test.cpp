// SPDX-License-Identifier: Apache-2.0
#include "render/horizon.h"

#include "render/line.h"
#include "render/triangle.h"

#include <algorithm>
#include <random>

#include <gmock/gmock.h>

namespace kushi {
namespace {

const Projection camera({.eye = {}, .target = {1, 0, 0}}, 256, 256);
constexpr TileGrid grid = {.width = 256, .height = 256, .tileShift = 8};

std::vector<SampleTile::Key> contentsOf(const SampleTile& tile) {
    std::vector<SampleTile::Key> keys;
    for (int y = 0; y < tile.size(); ++y) {
        for (int x = 0; x < tile.size(); ++x)
            keys.push_back(*tile.at(x, y));
    }
    return keys;
}

/// A wall over the tile's left half, a metre off.
SampleTile halfAWall() {
    SampleTile tile(256);
    tile.clear(0, 0);
    ScreenPolygon wall;
    for (const ScreenPoint corner :
         {ScreenPoint{-9, -9, 1}, {128, -9, 1}, {128, 300, 1}, {-9, 300, 1}}) {
        wall.corners[static_cast<std::size_t>(wall.size++)] = {corner, {}};
    }
    drawPolygon(tile, wall, camera, 1000);
    return tile;
}

TEST(Horizon, HidesWhatLiesBehindAWall) {
    Horizon horizon;
    horizon.look(halfAWall(), camera);
    const auto hides = [&](double fromX, double toX, double q) {
        return horizon.hides(boxOf({.a = {fromX, 30, q}, .b = {toX, 90, 0.5 * q}}));
    };
    EXPECT_TRUE(hides(20, 90, 0.99));
    EXPECT_TRUE(hides(-500, 90, 0.99));  // only what lies in the tile counts
    EXPECT_FALSE(hides(20, 90, 1.01));
    EXPECT_FALSE(hides(20, 140, 0.99));
    EXPECT_FALSE(hides(150, 240, 1e-6));
}

TEST(Horizon, SeesNothingHiddenInAnEmptyTile) {
    SampleTile tile(64);
    tile.clear(0, 0);
    Horizon horizon;
    horizon.look(tile, camera);
    EXPECT_FALSE(horizon.hides(boxOf({.a = {1, 1, 1e-30}, .b = {9, 9, 1e-30}})));
}

TEST(Horizon, NeverHidesWhatWouldShow) {
    std::mt19937 random(7);
    std::uniform_real_distribution<double> place(-40, 296);
    std::uniform_real_distribution<double> step(-60, 60);
    std::uniform_real_distribution<double> inverse(0.97, 1.03);
    SampleTile tile = halfAWall();
    Horizon horizon;
    int hidden = 0;
    for (int i = 0; i < 3000; ++i) {
        if (i % 100 == 0) horizon.look(tile, camera);
        ScreenSegment segment{.a = {place(random), place(random), inverse(random)}, .b = {}};
        segment.b = {segment.a.x + step(random), segment.a.y + step(random), inverse(random)};
        const bool isHidden = horizon.hides(boxOf(segment));
        hidden += static_cast<int>(isHidden);
        const auto before = isHidden ? contentsOf(tile) : std::vector<SampleTile::Key>();
        drawLine(tile, lineBetween(segment.a, segment.b, camera, grid), 1);
        if (isHidden) {
            ASSERT_EQ(contentsOf(tile), before) << i;
        }
    }
    EXPECT_GT(hidden, 100);
}

TEST(SampleTile, FindsTheFarthestOfASquare) {
    std::mt19937 random(8);
    SampleTile tile(64);
    tile.clear(0, 0);
    for (int y = 0; y < 64; ++y) {
        for (int x = 0; x < 64; ++x)
            *tile.at(x, y) = static_cast<SampleTile::Key>(random()) << 30;
    }
    for (const int size : {4, 8, 16}) {
        SampleTile::Key most = 0;
        for (int y = 32; y < 32 + size; ++y) {
            for (int x = 16; x < 16 + size; ++x)
                most = std::max(most, *tile.at(x, y));
        }
        EXPECT_EQ(tile.farthest(16, 32, size), most) << size;
    }
}

TEST(SampleTile, KeepsEverySampleAtAPlaceOfItsOwn) {
    for (const int size : {1, 16, 64}) {
        SampleTile tile(size);
        std::vector<const SampleTile::Key*> places;
        for (int y = -SampleTile::border; y < size + SampleTile::border; ++y) {
            for (int x = -SampleTile::border; x < size + SampleTile::border; ++x)
                places.push_back(tile.at(x, y));
        }
        std::sort(places.begin(), places.end());
        EXPECT_EQ(std::adjacent_find(places.begin(), places.end()), places.end()) << size;
    }
}

}  // namespace
}  // namespace kushi
