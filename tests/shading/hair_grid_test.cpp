// SPDX-License-Identifier: Apache-2.0
#include "shading/hair_grid.h"

#include "shading/crossings.h"
#include "shading/lattice.h"

#include <algorithm>
#include <cmath>
#include <cstring>
#include <limits>

#include <gtest/gtest.h>

namespace kushi {
namespace {

using test::lattice;

TEST(HairGrid, HoldsAllOfTheHair) {
    const Strands strands = lattice(20, 0.004F, 0.2F, 8e-5F);
    const HairGrid grid = hairGrid(strands, 40, 2);
    double sum = 0;
    for (const HairGrid::Cell& cell : grid.cells)
        sum += static_cast<double>(cell.density) * std::pow(grid.size, 3);
    EXPECT_NEAR(sum / (400 * 0.2 * 8e-5), 1, 0.01);
}

TEST(HairGrid, KnowsWhichWayHairRuns) {
    const HairGrid grid = hairGrid(lattice(20, 0.004F, 0.2F, 8e-5F), 40, 1);
    const HairGrid::Cell& cell = grid.cells[grid.cubeAt({0, 0.1F, 0})];
    ASSERT_GT(cell.density, 0);
    EXPECT_NEAR(cell.way.y, 1, 1e-3);
    EXPECT_NEAR(cell.crossings({0, 1, 0}), 0, 1e-3 * cell.density);
    EXPECT_NEAR(cell.crossings({1, 0, 0}), cell.density, 1e-3 * cell.density);
    const float slanting = std::sqrt(0.5F);
    EXPECT_NEAR(cell.crossings({slanting, slanting, 0}), slanting * cell.density,
                2e-3 * cell.density);
    // As many strands upside down: now it runs no way.
    Strands both = lattice(60, 0.0015F, 0.2F, 8e-5F);
    for (std::size_t i = 0; i < both.size(); i += 2)  // every other along z
        std::ranges::reverse(both.strand(i));
    const HairGrid mixed = hairGrid(both, 40, 1);
    float crossings = 0;
    float density = 0;
    for (int i = -30; i < 30; ++i) {
        const HairGrid::Cell& one =
            mixed.cells[mixed.cubeAt({1e-3F * static_cast<float>(i), 0.1F, 0})];
        crossings += one.crossings({0, 1, 0});
        density += one.density;
    }
    EXPECT_NEAR(crossings / density, 0.785, 0.1);
}

TEST(HairGrid, IsEmptyAtItsRim) {
    // However the sides of the cubes are rounded.
    for (int k = 0; k < 40; ++k) {
        const float height = 0.1F + 0.0037F * static_cast<float>(k);
        Strands mat;
        mat.add(std::vector<Vec3f>{{-0.05F, height, 0}, {0.05F, height, 0.02F}}, 0);
        const HairGrid grid = hairGrid(mat, 64, 1);
        for (std::size_t i = 0; i < grid.cells.size(); ++i) {
            const auto rows = static_cast<std::size_t>(grid.counts[1]);
            const std::size_t row = i / static_cast<std::size_t>(grid.counts[0]) % rows;
            if (row == 0 || row + 1 == rows) {
                ASSERT_EQ(grid.cells[i].density, 0) << height;
            }
        }
    }
}

TEST(HairGrid, TheSameFromAnyNumberOfThreads) {
    const Strands strands = lattice(110, 0.002F, 0.2F, 8e-5F, 3);
    const HairGrid one = hairGrid(strands, 64, 1);
    for (const int threads : {2, 3}) {
        const HairGrid more = hairGrid(strands, 64, threads);
        ASSERT_EQ(more.cells.size(), one.cells.size());
        EXPECT_EQ(std::memcmp(more.cells.data(), one.cells.data(),
                              one.cells.size() * sizeof(HairGrid::Cell)),
                  0);
    }
}

TEST(HairGrid, TakesWhatComes) {
    EXPECT_TRUE(hairGrid({}, 64, 1).empty());
    Strands strands = lattice(2, 0.01F, 0.1F, 8e-5F);
    strands.nodes[3].x = std::numeric_limits<float>::quiet_NaN();
    strands.diameters[30] = 1e30F;
    strands.diameters[33] = std::numeric_limits<float>::quiet_NaN();
    strands.diameters[36] = -1;
    strands.nodes[50] = strands.nodes[51];
    const HairGrid grid = hairGrid(strands, 64, 1);
    for (const HairGrid::Cell& cell : grid.cells)
        EXPECT_TRUE(std::isfinite(cell.density));
    Strands point;
    point.add(std::vector<Vec3f>{{1, 2, 3}}, 0);
    EXPECT_FALSE(hairGrid(point, 64, 1).empty());
}

TEST(HairGrid, PlacesLieBetweenTheMiddlesOfCubes) {
    const HairGrid grid = hairGrid(lattice(10, 0.01F, 0.1F, 8e-5F), 20, 1);
    for (const Vec3f place : {Vec3f{0.003F, 0.021F, -0.017F}, Vec3f{-0.031F, 0.08F, 0.04F}}) {
        const GridPlace found = placeIn(grid, place);
        Vec3f mean;
        for (std::size_t i = 0; i < 8; ++i)
            mean += found.weights[i] * grid.middle(found.cubes[i]);
        EXPECT_LT(length(mean - place), 1e-6F);
    }
    const GridPlace outside = placeIn(grid, {9, 9, 9});
    EXPECT_EQ(outside.cubes[7], grid.cells.size() - 1);
    EXPECT_NEAR(outside.weights[7], 1, 1e-6);
}

// Strands of 1.2 mm every 5.1 mm: a ray along x crosses each of 40 rows with a chance of 1.2 / 5.1.
TEST(Crossings, AreThoseOfALattice) {
    const Strands strands = lattice(40, 0.0051F, 0.3F, 0.0012F);
    const HairGrid grid = hairGrid(strands, 64, 1);
    // Cubes are about as wide as the pitch, so single ones have more or less.
    const auto at = [&](const std::vector<float>& values, float x) {
        float sum = 0;
        for (int i = -100; i < 100; ++i)
            sum += values[grid.cubeAt({x, 0.15F, 2.55e-4F * static_cast<float>(i)})];
        return sum / 200;
    };
    const std::vector<float> along = crossingsTowards(grid, {1, 0, 0}, 0);
    EXPECT_NEAR(at(along, -0.111F), 40 * 1.2 / 5.1, 0.4);
    EXPECT_NEAR(at(along, 0), 20 * 1.2 / 5.1, 0.4);
    EXPECT_NEAR(at(along, 0.111F), 0, 0.3);
    // Aslant in the horizontal plane the way is longer ...
    const float half = std::sqrt(0.5F);
    EXPECT_NEAR(at(crossingsTowards(grid, {half, 0, half}, 0), 0), std::sqrt(2.0) * 20 * 1.2 / 5.1,
                0.7);
    // ... upwards as well, but along the strands fewer are met on the same way.
    EXPECT_NEAR(at(crossingsTowards(grid, {0.8F, 0.6F, 0}, 0), 0), 20 * 1.2 / 5.1, 0.4);
    EXPECT_NEAR(at(crossingsTowards(grid, {0, 1, 0}, 0), 0), 0, 1e-2);
    // From the other side.
    EXPECT_NEAR(at(crossingsTowards(grid, {-1, 0, 0}, 0), 0.111F), 40 * 1.2 / 5.1, 0.4);
}

TEST(Crossings, AheadMeansNearerToTheLight) {
    const HairGrid grid = hairGrid(lattice(40, 0.0051F, 0.3F, 0.0012F), 64, 1);
    const std::size_t cube = grid.cubeAt({0.02F, 0.15F, 0});
    const std::vector<float> here = crossingsTowards(grid, {1, 0, 0}, 0);
    const std::vector<float> next = crossingsTowards(grid, {1, 0, 0}, 1);
    const std::size_t stride = grid.index(1, 0, 0);
    EXPECT_NEAR(next[cube], here[cube + stride], 1e-4);
    EXPECT_LT(next[cube], here[cube] - 0.1F);
}

}  // namespace
}  // namespace kushi
