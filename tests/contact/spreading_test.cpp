// SPDX-License-Identifier: Apache-2.0
#include "contact/spreading.h"

#include <algorithm>
#include <cmath>
#include <functional>
#include <numbers>

#include <gtest/gtest.h>

namespace kushi {
namespace {

constexpr float size = 0.005F;
constexpr float between = 0.001F;  // places of a lattice

const auto nowhere = [](Vec3f) { return false; };

// A lattice of places over a region of a cube of 10 cm about the origin.
std::vector<Vec3f> places(const std::function<bool(Vec3f)>& in) {
    std::vector<Vec3f> all;
    for (int x = -50; x < 50; ++x)
        for (int y = -50; y < 50; ++y)
            for (int z = -50; z < 50; ++z) {
                const Vec3f place =
                    between * Vec3f{static_cast<float>(x) + 0.5F, static_cast<float>(y) + 0.5F,
                                    static_cast<float>(z) + 0.5F};
                if (in(place)) all.push_back(place);
            }
    return all;
}

// With so much hair at each place that it fills `packing` of a lattice.
Density heap(const std::vector<Vec3f>& places, double packing) {
    const std::vector<Vec3f> box = {{-0.05F, -0.05F, -0.05F}, {0.05F, 0.05F, 0.05F}};
    Density density(voxelsAround(box, size));
    const Vec3f half = {0.25F * between, 0, 0};
    const double section = packing * std::pow(double{between}, 3) / (0.5 * double{between});
    for (const Vec3f place : places)
        density.add(std::vector<Vec3f>{place - half, place + half}, section);
    return density;
}

TEST(Spreading, DrawsASlabOutToAsThickAsItMustBe) {
    // Between walls, so that it can only become thicker: by three times.
    const auto channel = [](Vec3f p) { return std::max(std::abs(p.y), std::abs(p.z)) > 0.03F; };
    const auto slab = places([&](Vec3f p) { return !channel(p) && std::abs(p.x) < 0.01F; });
    const Spreading spreading(heap(slab, 0.3), 0.1F, channel);
    // Half a voxel from the faces, which voxels see as a blur.
    for (float x = -0.0075F; x < 0.008F; x += 0.001F) {
        const Vec3f way = spreading.way({x, 0.002F, -0.004F});
        EXPECT_NEAR(double{way.x}, double{2 * x}, 2e-3) << x;
        EXPECT_NEAR(double{std::hypot(way.y, way.z)}, 0, 2e-4) << x;
    }
}

TEST(Spreading, MakesOfABallOneOfTheVolumeThatItNeeds) {
    auto ball = places([](Vec3f p) { return length(p) < 0.015F; });
    const double volume = 4 * std::numbers::pi / 3 * std::pow(0.015, 3);
    for (int step = 0; step < 3; ++step) {
        const Spreading spreading(heap(ball, 0.4), 0.1F, nowhere);
        for (Vec3f& place : ball)
            place = place + spreading.way(place);
    }
    const Density spread = heap(ball, 0.4);
    EXPECT_LT(spread.largestPacking(), 0.12F);
    double farthest = 0;
    for (const Vec3f place : ball)
        farthest = std::max(farthest, double{length(place)});
    EXPECT_NEAR(farthest, std::cbrt(4 * volume / (4 * std::numbers::pi / 3)), 0.5 * double{size});
}

TEST(Spreading, GoesOutOfAHeapThatLiesOnAWall) {
    const auto wall = [](Vec3f p) { return p.y < 0; };
    const auto heaped = places([&](Vec3f p) { return !wall(p) && length(p) < 0.015F; });
    const Spreading spreading(heap(heaped, 0.4), 0.1F, wall);
    double up = 0;
    for (const Vec3f place : heaped) {
        const Vec3f way = spreading.way(place);
        EXPECT_GT(place.y + way.y, -0.1F * size);
        up += double{way.y};
    }
    EXPECT_GT(up / static_cast<double>(heaped.size()), 2e-3);
}

TEST(Spreading, LeavesWhatHasRoomWhereItIs) {
    const auto ball = places([](Vec3f p) { return length(p) < 0.015F; });
    const Spreading enough(heap(ball, 0.4), 0.45F, nowhere);
    const Spreading spreading(heap(ball, 0.4), 0.3F, nowhere);
    EXPECT_EQ(enough.way({0.01F, 0, 0}), Vec3f{});
    EXPECT_GT(spreading.way({0.01F, 0, 0}).x, 0);
    EXPECT_EQ(spreading.way({0.04F, 0, 0}), Vec3f{});
}

}  // namespace
}  // namespace kushi
