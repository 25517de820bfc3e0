// SPDX-License-Identifier: Apache-2.0
//
// Distance fields at places side by side against one place after the other.
#include "rod/analytic_field.h"
#include "rod/kernel/field-inl.h"
#include "rod/kernel/gather-inl.h"

#include <limits>
#include <random>

#include <gtest/gtest.h>

namespace kushi {
namespace {

namespace kernel = HWY_NAMESPACE;
using kernel::LaneField;
using kernel::Lanes;

constexpr double h = 0.0025;  // m

std::array<float, Lanes::count> numbers(Lanes lanes) {
    alignas(64) std::array<float, Lanes::count> out{};
    kernel::storeLanes(lanes, out.data());
    return out;
}

// Places by the surface and far off, outside of the grid, and none at all.
std::vector<Vec3f> somePlaces() {
    std::mt19937_64 engine(3);
    const auto draw = [&](double low, double high) {
        return std::uniform_real_distribution<double>(low, high)(engine);
    };
    std::vector<Vec3f> places;
    while (places.size() < 20000) {
        const double x = draw(-0.27, 0.22), y = draw(-0.67, 0.17);
        const Vec3d at = {x, y, draw(-0.32, 0.32)};
        if (places.size() % 4 == 0 || std::abs(rest::bustDistance(at)) < 0.01)
            places.push_back(at.as<float>());
    }
    const float nan = std::numeric_limits<float>::quiet_NaN();
    const float inf = std::numeric_limits<float>::infinity();
    for (const float far : {nan, inf, -inf, 1e30F, -1e30F, 3e9F}) {
        places.push_back({far, 0, 0});
        places.push_back({0, far, 0});
        places.push_back({0, 0, far});
    }
    return places;
}

template <class Visit>
void forBlocks(const std::vector<Vec3f>& places, const Visit& visit) {
    for (std::size_t i = 0; i < places.size(); i += Lanes::count) {
        const auto place = [&](std::size_t lane) {
            return places[std::min(i + lane, places.size() - 1)];
        };
        visit(kernel::gatherVector<Lanes>(place), place);
    }
}

TEST(LaneField, LooksAsOneProbeAfterTheOther) {
    const DistanceField field = rest::bust();
    const LaneField<Lanes> lanes(field);
    const LaneField<double> one(field);
    const std::vector<Vec3f> places = somePlaces();
    for (const double near : {0.002, 0.02}) {
        int looked = 0;
        forBlocks(places, [&](const auto& at, const auto& place) {
            kernel::Nearness<Lanes> found;
            const bool any = lanes.look(at, Lanes(static_cast<float>(near)), found);
            const auto distance = numbers(found.distance);
            for (std::size_t l = 0; l < Lanes::count; ++l) {
                const Vec3d p = place(l).template as<double>();
                kernel::Nearness<double> exact;
                const bool within = one.look({p.x, p.y, p.z}, near, exact);
                if (!within) {
                    // By a hair's breadth either way.
                    EXPECT_GT(distance[l], near - 1e-7);
                    continue;
                }
                ASSERT_TRUE(any);
                ++looked;
                EXPECT_NEAR(distance[l], exact.distance, 1e-7);
                for (int r = 0; r < 3; ++r) {
                    EXPECT_NEAR(numbers(found.normal[r])[l], exact.normal[r], 1e-4);
                    for (int c = 0; c < 3; ++c)
                        EXPECT_NEAR(numbers(found.curvature(r, c))[l], exact.curvature(r, c),
                                    1e-4 / h);
                }
            }
        });
        EXPECT_GT(looked, 4000);
    }
}

// Where it is more than what is asked for, it may be less than it is by what the next sample may.
TEST(LaneField, TellsDistancesAsTheFieldDoes) {
    const DistanceField field = rest::bust();
    const LaneField<Lanes> lanes(field);
    for (const double near : {0.002, 0.02}) {
        forBlocks(somePlaces(), [&](const auto& at, const auto& place) {
            const auto distance = numbers(lanes.distance(at, Lanes(static_cast<float>(near))));
            for (std::size_t l = 0; l < Lanes::count; ++l) {
                const Vec3d p = place(l).template as<double>();
                const Vec3d inGrid = {std::clamp(p.x, -0.25, 0.2), std::clamp(p.y, -0.65, 0.15),
                                      std::clamp(p.z, -0.3, 0.3)};
                if (inGrid != p) {
                    EXPECT_GT(distance[l], near) << p.x << ' ' << p.y << ' ' << p.z;
                    continue;
                }
                const double exact = distanceAt(field, place(l));
                if (exact <= near) {
                    EXPECT_NEAR(distance[l], exact, 1e-7);
                } else {
                    EXPECT_GT(distance[l], near - 1e-7);
                    if (distance[l] < 0.9F) {
                        EXPECT_LT(distance[l], exact + 1e-7);
                        EXPECT_GT(distance[l], exact - 3 * h);
                    }
                }
            }
        });
    }
}

}  // namespace
}  // namespace kushi
