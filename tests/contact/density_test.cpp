// SPDX-License-Identifier: Apache-2.0
#include "contact/density.h"

#include <algorithm>
#include <cmath>

#include <gtest/gtest.h>

namespace kushi {
namespace {

const std::vector<Vec3f> box = {{0, 0, 0}, {0.1F, 0.05F, 0.04F}};

std::vector<Vec3f> line(Vec3f from, Vec3f to, int segments) {
    std::vector<Vec3f> nodes;
    for (int j = 0; j <= segments; ++j)
        nodes.push_back(from +
                        (static_cast<float>(j) / static_cast<float>(segments)) * (to - from));
    return nodes;
}

double total(const Density& density) {
    double sum = 0;
    for (std::size_t i = 0; i < density.voxels().total(); ++i)
        sum += double{density.packing(i)};
    return sum * std::pow(double{density.voxels().size}, 3);
}

TEST(Density, HoldsTheVolumeOfTheHair) {
    Density density(voxelsAround(box, 0.005F));
    const double section = 5e-9;
    density.add(line({0.01F, 0.01F, 0.01F}, {0.09F, 0.04F, 0.03F}, 7), section);
    EXPECT_NEAR(total(density), std::hypot(0.08, 0.03, 0.02) * section, 1e-3 * 4e-10);
}

TEST(Density, OfParallelHairIsHairsToTheAreaTimesTheirSection) {
    Density density(voxelsAround(box, 0.005F));
    // A hair on each square millimetre, along x.
    for (int i = 0; i < 50; ++i)
        for (int k = 0; k < 40; ++k) {
            const auto y = static_cast<float>(0.001 * (i + 0.5));
            const auto z = static_cast<float>(0.001 * (k + 0.5));
            density.add(line({0, y, z}, {0.1F, y, z}, 20), 5e-9);
        }
    EXPECT_NEAR(double{density.largestPacking()}, 5e-9 / 1e-6, 0.1 * 5e-3);
    EXPECT_NEAR(density.volume(0.0025F), 0.1 * 0.05 * 0.04, 0.1 * 2e-4);
}

TEST(Density, DoesNotDependOnTheOrder) {
    const Voxels voxels = voxelsAround(box, 0.005F);
    const auto a = line({0, 0, 0}, {0.1F, 0.05F, 0.04F}, 9);
    const auto b = line({0, 0.05F, 0}, {0.1F, 0, 0.04F}, 13);
    Density one(voxels);
    one.add(a, 4e-9);
    one.add(b, 7e-9);
    Density other(voxels);
    Density part(voxels);
    part.add(a, 4e-9);
    other.add(b, 7e-9);
    other.add(part);
    for (std::size_t i = 0; i < voxels.total(); ++i)
        ASSERT_EQ(one.packing(i), other.packing(i));
}

}  // namespace
}  // namespace kushi
