// SPDX-License-Identifier: Apache-2.0
#include "render/area.h"

#include <array>
#include <cmath>
#include <random>

#include <gmock/gmock.h>

namespace kushi {
namespace {

constexpr int size = 16;
using Areas = std::array<std::array<double, size>, size>;  // by row

Areas areasOf(AreaCoverage& coverage, std::vector<PixelPoint> corners) {
    Areas areas{};
    coverage.cover(corners, [&](int x, int y, float area) {
        auto& place = areas[static_cast<std::size_t>(y)][static_cast<std::size_t>(x)];
        EXPECT_EQ(place, 0) << "visited twice";
        place = area;
    });
    return areas;
}

/// By counting: whether points lie on the same side of all edges.
Areas counted(const std::vector<PixelPoint>& corners) {
    constexpr int fine = 64;
    Areas areas{};
    for (int y = 0; y < size * fine; ++y) {
        for (int x = 0; x < size * fine; ++x) {
            const double px = (x + 0.5) / fine;
            const double py = (y + 0.5) / fine;
            int sides = 0;
            for (std::size_t i = 0; i < corners.size(); ++i) {
                const PixelPoint a = corners[i];
                const PixelPoint b = corners[(i + 1) % corners.size()];
                sides += (b.x - a.x) * (py - a.y) - (b.y - a.y) * (px - a.x) > 0 ? 1 : -1;
            }
            if (std::abs(sides) != static_cast<int>(corners.size())) continue;
            areas[static_cast<std::size_t>(y / fine)][static_cast<std::size_t>(x / fine)] +=
                1.0 / (fine * fine);
        }
    }
    return areas;
}

TEST(AreaCoverage, IsTheAreaOfEachPixelWithin) {
    AreaCoverage coverage(size);
    const Areas areas = areasOf(coverage, {{2.25, 3.5}, {5.5, 3.5}, {5.5, 5.25}, {2.25, 5.25}});
    EXPECT_FLOAT_EQ(static_cast<float>(areas[3][2]), 0.375F);
    EXPECT_FLOAT_EQ(static_cast<float>(areas[4][2]), 0.75F);
    EXPECT_FLOAT_EQ(static_cast<float>(areas[4][3]), 1);
    EXPECT_FLOAT_EQ(static_cast<float>(areas[5][5]), 0.125F);
    EXPECT_EQ(areas[6][3], 0);
    EXPECT_EQ(areas[4][6], 0);
}

// Inside, across all of the tile's edges, and thin as hair.
TEST(AreaCoverage, AgreesWithCounting) {
    std::mt19937 random(1);
    std::uniform_real_distribution<double> place(-6, 22);
    std::uniform_real_distribution<double> turn(0, 6.3);
    AreaCoverage coverage(size);
    for (int i = 0; i < 60; ++i) {
        const double angle = turn(random);
        const double half = i % 3 == 0 ? 0.1 : 1.7;
        const PixelPoint middle = {place(random), place(random)};
        const double alongX = 9 * std::cos(angle);
        const double alongY = 9 * std::sin(angle);
        const double sideX = -half * std::sin(angle);
        const double sideY = half * std::cos(angle);
        std::vector<PixelPoint> corners = {{middle.x - alongX - sideX, middle.y - alongY - sideY},
                                           {middle.x + alongX - sideX, middle.y + alongY - sideY},
                                           {middle.x + alongX + sideX, middle.y + alongY + sideY},
                                           {middle.x - alongX + sideX, middle.y - alongY + sideY}};
        if (i % 2 == 0) std::swap(corners[1], corners[3]);
        const Areas areas = areasOf(coverage, corners);
        const Areas truth = counted(corners);
        for (std::size_t y = 0; y < size; ++y) {
            for (std::size_t x = 0; x < size; ++x)
                ASSERT_NEAR(areas[y][x], truth[y][x], 0.02) << i << ": " << x << ' ' << y;
        }
    }
}

TEST(AreaCoverage, GivesNeighboursWhatTheOtherLeaves) {
    AreaCoverage coverage(size);
    const PixelPoint a = {3.3, -4.1};
    const PixelPoint b = {12.9, 19.7};
    const Areas left = areasOf(coverage, {{-5, -5}, a, b, {-5, 30}});
    const Areas right = areasOf(coverage, {a, {40, -5}, {40, 30}, b});
    for (std::size_t y = 0; y < size; ++y) {
        for (std::size_t x = 0; x < size; ++x)
            EXPECT_NEAR(left[y][x] + right[y][x], 1, 1e-5) << x << ' ' << y;
    }
}

TEST(AreaCoverage, CoversNothingOutsideOrWithoutArea) {
    AreaCoverage coverage(size);
    for (const std::vector<PixelPoint>& corners :
         {std::vector<PixelPoint>{{-9, 2}, {-3, 2}, {-3, 8}, {-9, 8}},
          {{20, 2}, {23, 2}, {23, 8}, {20, 8}},
          {{2, -9}, {8, -9}, {8, -2}, {2, -2}},
          {{2, 19}, {8, 19}, {8, 22}, {2, 22}},
          {{2, 2}, {9, 9}, {9, 9}, {2, 2}}}) {
        coverage.cover(corners, [](int x, int y, float area) {
            ADD_FAILURE() << x << ' ' << y << ' ' << area;
        });
    }
}

}  // namespace
}  // namespace kushi
