// SPDX-License-Identifier: Apache-2.0
#include "render/triangle.h"

#include <random>

#include <gmock/gmock.h>

namespace kushi {
namespace {

const Projection camera({.eye = {}, .target = {1, 0, 0}}, 64, 64);

ScreenPolygon polygonOf(const std::vector<ScreenPoint>& points) {
    ScreenPolygon polygon;
    for (const ScreenPoint point : points) {
        polygon.corners[static_cast<std::size_t>(polygon.size++)] = {point, {}};
    }
    return polygon;
}

std::vector<std::uint8_t> covered(const ScreenPolygon& polygon) {
    SampleTile tile(64);
    tile.clear(0, 0);
    drawPolygon(tile, polygon, camera, 1);
    std::vector<std::uint8_t> samples;
    for (int y = 0; y < 64; ++y) {
        for (int x = 0; x < 64; ++x)
            samples.push_back(SampleTile::id(*tile.at(x, y)) == 1 ? 1 : 0);
    }
    return samples;
}

TEST(Polygon, CoversTheSamplesWhoseCentreLiesInside) {
    const std::vector<ScreenPoint> corners = {{3.2, 5.1, 1}, {57.3, 11.8, 1}, {20.4, 60.2, 1}};
    const auto inside = [&](double x, double y) {
        for (std::size_t i = 0; i < 3; ++i) {
            const ScreenPoint a = corners[i];
            const ScreenPoint b = corners[(i + 1) % 3];
            if ((b.x - a.x) * (y - a.y) - (b.y - a.y) * (x - a.x) < 0) return 0;
        }
        return 1;
    };
    for (const auto& [i, j, k] : {std::array<std::size_t, 3>{0, 1, 2}, {2, 1, 0}, {1, 0, 2}}) {
        const auto samples = covered(polygonOf({corners[i], corners[j], corners[k]}));
        for (std::size_t sample = 0; sample < samples.size(); ++sample) {
            const std::size_t column = sample % 64;
            const std::size_t row = sample / 64;
            const double x = static_cast<double>(column) + 0.5;
            const double y = static_cast<double>(row) + 0.5;
            ASSERT_EQ(samples[sample], inside(x, y)) << x << ' ' << y;
        }
    }
}

TEST(Polygon, LeavesNoGapAndNoOverlapToItsNeighbours) {
    // A fan around a point, with corners on sample centres among others, tiles a square exactly.
    std::mt19937 random(5);
    std::uniform_real_distribution<double> place(10, 50);
    for (int i = 0; i < 100; ++i) {
        ScreenPoint middle = {place(random), place(random), 1};
        if (i % 2 == 0) middle = {std::floor(middle.x) + 0.5, std::floor(middle.y) + 0.5, 1};
        const std::vector<ScreenPoint> rim = {{4.5, 4.5, 1},   {30.5, 4.5, 1},  {60.5, 4.5, 1},
                                              {60.5, 60.5, 1}, {21.3, 60.5, 1}, {4.5, 60.5, 1}};
        std::vector<int> sum(64 * 64, 0);
        for (std::size_t j = 0; j < rim.size(); ++j) {
            const auto samples = covered(polygonOf({middle, rim[j], rim[(j + 1) % rim.size()]}));
            for (std::size_t k = 0; k < sum.size(); ++k)
                sum[k] += samples[k];
        }
        for (int k = 0; k < 64 * 64; ++k) {
            const bool inSquare = k % 64 >= 4 && k % 64 < 60 && k / 64 >= 4 && k / 64 < 60;
            ASSERT_EQ(sum[static_cast<std::size_t>(k)], inSquare ? 1 : 0)
                << k % 64 << ' ' << k / 64 << " of fan " << i;
        }
    }
}

TEST(Polygon, HasDepthLinearInOneOverDistance) {
    SampleTile tile(64);
    tile.clear(0, 0);
    drawPolygon(tile, polygonOf({{0, 0, 0.2}, {64, 0, 0.5}, {0, 64, 0.8}}), camera, 1);
    for (int y = 0; y < 63; ++y) {
        for (int x = 0; x + y < 63; ++x) {
            const double q = 0.2 + 0.3 * (x + 0.5) / 64 + 0.6 * (y + 0.5) / 64;
            const double depth = static_cast<double>(*tile.at(x, y)) / Projection::fullDepth;
            ASSERT_NEAR(depth, 1 - q * camera.nearPlane(), 2e-9) << x << ' ' << y;
        }
    }
}

TEST(Polygon, StaysWithinItsDepthsHoweverThin) {
    std::mt19937 random(6);
    std::uniform_real_distribution<double> place(-20, 84);
    std::uniform_real_distribution<double> offset(-1e-3, 1e-3);
    std::uniform_real_distribution<double> inverse(0.2, 0.9);
    for (int i = 0; i < 500; ++i) {
        const ScreenPoint a = {place(random), place(random), inverse(random)};
        const ScreenPoint b = {place(random), place(random), inverse(random)};
        const ScreenPoint c = {0.5 * (a.x + b.x) + offset(random),
                               0.5 * (a.y + b.y) + offset(random), inverse(random)};
        SampleTile tile(64);
        tile.clear(0, 0);
        drawPolygon(tile, polygonOf({a, b, c}), camera, 1);
        const double low = 1 - std::max({a.q, b.q, c.q}) * camera.nearPlane();
        const double high = 1 - std::min({a.q, b.q, c.q}) * camera.nearPlane();
        for (int y = 0; y < 64; ++y) {
            for (int x = 0; x < 64; ++x) {
                if (SampleTile::id(*tile.at(x, y)) != 1) continue;
                const double depth = static_cast<double>(*tile.at(x, y)) / Projection::fullDepth;
                ASSERT_GT(depth, low - 2e-9);
                ASSERT_LT(depth, high + 2e-9);
            }
        }
    }
}

TEST(Polygon, KnowsItsTiles) {
    const TileGrid grid = {.width = 200, .height = 100, .tileShift = 6};
    const auto boxOf = [&](const std::vector<ScreenPoint>& points) {
        const TileBox box = tilesOf(polygonOf(points), grid);
        return std::array{box.left, box.top, box.right, box.bottom};
    };
    EXPECT_EQ(boxOf({{10, 10}, {20, 10}, {10, 20}}), (std::array{0, 0, 1, 1}));
    EXPECT_EQ(boxOf({{70, 10}, {150, 10}, {70, 90}}), (std::array{1, 0, 3, 2}));
    EXPECT_EQ(boxOf({{-1e9, -1e9}, {1e9, 10}, {10, 1e9}}), (std::array{0, 0, 4, 2}));
    const auto nowhere = boxOf({{-20, 10}, {-10, 10}, {-20, 20}});
    EXPECT_GE(nowhere[0], nowhere[2]);
    const auto below = boxOf({{20, 300}, {10, 310}, {20, 320}});
    EXPECT_GE(below[1], below[3]);
}

}  // namespace
}  // namespace kushi
