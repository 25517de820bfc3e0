// SPDX-License-Identifier: Apache-2.0
#include "render/line.h"

#include <map>
#include <random>
#include <set>
#include <utility>

#include <gmock/gmock.h>

namespace kushi {
namespace {

using Samples = std::multiset<std::pair<int, int>>;

const Projection camera({.eye = {}, .target = {1, 0, 0}}, 256, 256);
constexpr TileGrid oneTile = {.width = 256, .height = 256, .tileShift = 8};
constexpr TileGrid manyTiles = {.width = 256, .height = 256, .tileShift = 4};

/// The samples of the picture that a line covers, tile by tile.
Samples covered(ScreenPoint a, ScreenPoint b, const TileGrid& grid = oneTile) {
    a.q = b.q = 1;
    const Line line = lineBetween(a, b, camera, grid);
    Samples samples;
    SampleTile tile(grid.tileSize());
    forEachTile(line, grid, [&](int column, int row) {
        tile.clear(column * grid.tileSize(), row * grid.tileSize());
        drawLine(tile, line, 7);
        for (int y = 0; y < tile.size(); ++y) {
            for (int x = 0; x < tile.size(); ++x) {
                if (SampleTile::id(*tile.at(x, y)) == 7)
                    samples.emplace(tile.x() + x, tile.y() + y);
            }
        }
    });
    return samples;
}

TEST(Line, CoversOneSampleAColumn) {
    EXPECT_EQ(covered({10.5, 20.5}, {14.5, 20.5}),
              (Samples{{10, 20}, {11, 20}, {12, 20}, {13, 20}}));
    EXPECT_EQ(covered({10.2, 20.9}, {10.3, 24.1}), (Samples{{10, 21}, {10, 22}, {10, 23}}));
    EXPECT_EQ(covered({3, 3.5}, {6, 6.5}).count({4, 4}), 1U);
}

TEST(Line, OwnsItsFirstEndAndNotItsLast) {
    // The ends lie on the centres of samples.
    EXPECT_EQ(covered({10.5, 20.5}, {12.5, 20.5}), (Samples{{10, 20}, {11, 20}}));
    EXPECT_EQ(covered({12.5, 20.5}, {10.5, 20.5}), (Samples{{11, 20}, {12, 20}}));
    EXPECT_EQ(covered({20.5, 12.5}, {20.5, 10.5}), (Samples{{20, 11}, {20, 12}}));
    EXPECT_TRUE(covered({20.5, 12.5}, {20.5, 12.5}).empty());
}

TEST(Line, SharesNodesSoThatTheyAreDrawnOnce) {
    // A node in a polyline that goes on, one where it turns back, and one where
    // it turns a corner.
    const ScreenPoint a = {10.5, 30.5};
    const ScreenPoint b = {20.5, 30.5};
    for (const ScreenPoint c : {ScreenPoint{30.5, 30.5}, {12.5, 32.5}, {20.5, 40.5}, {20.5, 5.5}}) {
        Samples both = covered(a, b);
        both.merge(covered(b, c));
        EXPECT_EQ(both.count({20, 30}), 1U) << c.x << ' ' << c.y;
    }
}

TEST(Line, CoversAsManySamplesAsItIsLongAtAnyPlaceAndSlope) {
    std::mt19937 random(1);
    std::uniform_real_distribution<double> place(120, 136);
    std::uniform_real_distribution<double> half(1, 100);
    for (int degree = 0; degree < 360; degree += 3) {
        const Vec3d direction = {std::cos(radians(degree)), std::sin(radians(degree)), 0};
        for (int i = 0; i < 15; ++i) {
            const double x = place(random);
            const double y = place(random);
            const double l = half(random);
            const Samples samples = covered({x - l * direction.x, y - l * direction.y},
                                            {x + l * direction.x, y + l * direction.y});
            // One column more or less than the line is wide, and one sample's
            // rounding.
            EXPECT_NEAR(static_cast<double>(samples.size()), 2 * l, 2.42)
                << degree << ' ' << x << ' ' << y << ' ' << l;
        }
    }
}

TEST(Line, CoversItsLengthOnAverageToAThousandth) {
    // Short lines too: what is rounded up here is rounded down there.
    std::mt19937 random(2);
    std::uniform_real_distribution<double> place(20, 236);
    std::uniform_real_distribution<double> turn(0, 2 * std::numbers::pi);
    for (const double length : {0.3, 1.0, 5.7, 20.0}) {
        const int tries = length < 2 ? 200000 : 20000;
        std::size_t sum = 0;
        for (int i = 0; i < tries; ++i) {
            const double angle = turn(random);
            const ScreenPoint a = {place(random), place(random), 1};
            const ScreenPoint b = {a.x + length * std::cos(angle), a.y + length * std::sin(angle),
                                   1};
            const Line line = lineBetween(a, b, camera, oneTile);
            const std::int64_t columns = std::int64_t{line.last} - line.first;
            sum += static_cast<std::size_t>(columns * line.whole);
            for (std::int64_t at = line.more; line.moreStep > 0 && at < columns << 32;
                 at += line.moreStep)
                ++sum;
        }
        // Three standard deviations of a sum of roundings.
        EXPECT_NEAR(static_cast<double>(sum) / tries, length, 3 * 0.7 / std::sqrt(tries)) << length;
    }
}

TEST(Line, KeepsItsColumnsWhereverItLies) {
    for (int i = 0; i < 16; ++i) {
        const double shift = i / 16.0;
        std::set<int> columns;
        for (const auto& [x, y] : covered({20.5 + shift, 40 + shift}, {60.5 + shift, 71 + shift})) {
            columns.insert(x);
        }
        EXPECT_EQ(columns.size(), 40U) << shift;
    }
}

TEST(Line, PassesThroughTheMiddleOfWhatItCovers) {
    for (const double slope : {-1.0, -0.77, -0.3, 0.0, 0.21, 0.5, 0.9, 1.0}) {
        double sum = 0;
        double count = 0;
        for (int i = 0; i < 64; ++i) {
            const double shift = i / 64.0;
            const ScreenPoint a = {5, 128 - 123 * slope + shift};
            const ScreenPoint b = {251, 128 + 123 * slope + shift};
            for (const auto& [x, y] : covered(a, b)) {
                sum += y + 0.5 - (a.y + (x + 0.5 - a.x) * slope);
                ++count;
            }
        }
        EXPECT_NEAR(sum / count, 0, 0.01) << slope;
    }
}

TEST(Line, StaysWithinASampleOfItsPlace) {
    std::mt19937 random(3);
    std::uniform_real_distribution<double> place(1, 255);
    for (int i = 0; i < 300; ++i) {
        const ScreenPoint a = {place(random), place(random)};
        const ScreenPoint b = {place(random), place(random)};
        const Vec3d direction = normalized(Vec3d{b.x - a.x, b.y - a.y, 0});
        for (const auto& [x, y] : covered(a, b)) {
            const double away = (x + 0.5 - a.x) * direction.y - (y + 0.5 - a.y) * direction.x;
            EXPECT_LT(std::abs(away), 1.0);
        }
    }
}

TEST(Line, DoesNotCareHowThePictureIsCut) {
    std::mt19937 random(4);
    std::uniform_real_distribution<double> place(-300, 550);
    for (int i = 0; i < 500; ++i) {
        const ScreenPoint a = {place(random), place(random)};
        const ScreenPoint b = {place(random), place(random)};
        ASSERT_EQ(covered(a, b, oneTile), covered(a, b, manyTiles))
            << a.x << ' ' << a.y << "  " << b.x << ' ' << b.y;
    }
}

TEST(Line, CoversTheSameWhenItsEndsLieFarOutside) {
    // The same straight line, 25 times and a million times as long.
    const auto along = [](double t) { return ScreenPoint{128 + t, 100 + 0.375 * t}; };
    const Samples near = covered(along(-2000), along(2000));
    EXPECT_EQ(near.size(), 273U);  // 256 sqrt(1 + 0.375^2) = 273.4
    EXPECT_EQ(covered(along(-50000), along(50000), manyTiles), near);
    EXPECT_EQ(covered(along(-0x1p29), along(0x1p29), manyTiles), near);
}

TEST(Line, HasDepthLinearInOneOverDistance) {
    const ScreenPoint a = {10.5, 50.5, 1 / 2.0};
    const ScreenPoint b = {110.5, 50.5, 1 / 8.0};
    const Line line = lineBetween(a, b, camera, oneTile);
    SampleTile tile(256);
    tile.clear(0, 0);
    drawLine(tile, line, 1);
    for (int x = 10; x < 110; ++x) {
        const double q = 0.5 + (x - 10) / 100.0 * (0.125 - 0.5);
        const double depth = static_cast<double>(*tile.at(x, 50)) / Projection::fullDepth;
        EXPECT_NEAR(depth, 1 - q * camera.nearPlane(), 2e-9) << x;
    }
}

}  // namespace
}  // namespace kushi
