// SPDX-License-Identifier: Apache-2.0
#include <kushi/follicles.h>

#include <algorithm>
#include <cmath>
#include <map>
#include <set>

#include <gtest/gtest.h>

namespace kushi {
namespace {

constexpr double pi = std::numbers::pi;

Scalp scalp(double spacing, double jitter) {
    Scalp s;
    s.ellipsoid = {{0.01, 0.02, 0}, {0.105, 0.125, 0.085}, radians(20)};
    s.spacing = spacing;
    s.jitter = jitter;
    return s;
}

// By chords of a fine subdivision, independently of the library's tables.
double arcAlongPhi(const Ellipsoid& e, double theta, double from, double to) {
    constexpr int steps = 400;
    double sum = 0;
    for (int i = 0; i < steps; ++i) {
        sum += length(e.point({theta, from + (to - from) * (i + 1) / steps}) -
                      e.point({theta, from + (to - from) * i / steps}));
    }
    return sum;
}

double meanArcAlongTheta(const Ellipsoid& e, double from, double to) {
    constexpr int meridians = 90;
    double sum = 0;
    for (int m = 0; m < meridians; ++m) {
        const double phi = 2 * pi * m / meridians;
        for (int i = 0; i < 40; ++i) {
            sum += length(e.point({from + (to - from) * (i + 1) / 40, phi}) -
                          e.point({from + (to - from) * i / 40, phi}));
        }
    }
    return sum / meridians;
}

// Rows of an unjittered scalp: phi of each follicle by theta.
std::map<double, std::vector<double>> rowsOf(const Follicles& follicles) {
    std::map<double, std::vector<double>> rows;
    for (const EllipsoidAngles& at : follicles.angles)
        rows[at.theta].push_back(at.phi);
    for (auto& [theta, phis] : rows)
        std::sort(phis.begin(), phis.end());
    return rows;
}

TEST(Plant, RowsAreEquallySpacedAlongTheMeanMeridian) {
    const Scalp s = scalp(0.004, 0);
    const auto rows = rowsOf(*plant(s, 1));
    ASSERT_GT(rows.size(), 60U);
    double last = 0;
    bool first = true;
    for (const auto& [theta, phis] : rows) {
        EXPECT_NEAR(meanArcAlongTheta(s.ellipsoid, last, theta), first ? 0.002 : 0.004, 2e-6);
        last = theta;
        first = false;
    }
}

TEST(Plant, FolliclesAlongARowAreEquallySpacedByArcLength) {
    const Scalp s = scalp(0.004, 0);
    for (const auto& [theta, phis] : rowsOf(*plant(s, 1))) {
        const double around = arcAlongPhi(s.ellipsoid, theta, 0, 2 * pi);
        const double step = around / static_cast<double>(phis.size());
        if (phis.size() > 10) {
            EXPECT_NEAR(step, 0.004, 0.004 / (2 * static_cast<double>(phis.size()) - 1));
        }
        for (std::size_t i = 0; i + 1 < phis.size(); ++i) {
            ASSERT_NEAR(arcAlongPhi(s.ellipsoid, theta, phis[i], phis[i + 1]), step, 0.001 * step);
        }
    }
}

TEST(Plant, EveryFollicleLiesOnTheEllipsoidAtItsAngles) {
    const Scalp s = scalp(0.003, 1);
    const Follicles follicles = *plant(s, 3);
    for (std::size_t i = 0; i < follicles.size(); ++i) {
        ASSERT_NEAR(s.ellipsoid.implicit(follicles.roots[i]), 0, 1e-12);
        ASSERT_LT(length(s.ellipsoid.point(follicles.angles[i]) - follicles.roots[i]), 1e-12);
        ASSERT_GE(follicles.angles[i].phi, -pi);
        ASSERT_LT(follicles.angles[i].phi, pi);
    }
}

// Jitter moves each follicle by at most half of jitter spacings along both; unjittered follicles
// have the same keys.
TEST(Plant, JitterStaysWithinItsReachAndFillsIt) {
    const Follicles still = *plant(scalp(0.003, 0), 3);
    const Follicles moved = *plant(scalp(0.003, 0.8), 3);
    ASSERT_EQ(still.keys, moved.keys);
    const Ellipsoid ellipsoid = scalp(0.003, 0).ellipsoid;
    const double reach = 0.5 * 0.8 * 0.003;
    double mostAlongTheta = 0;
    double mostAlongPhi = 0;
    for (std::size_t i = 0; i < still.size(); ++i) {
        const auto [theta, phi] = still.angles[i];
        if (theta < 0.1 || theta > pi - 0.1) continue;  // where jitter may cross a pole
        const Vec3d halfway = ellipsoid.point({theta, moved.angles[i].phi});
        mostAlongPhi = std::max(mostAlongPhi, length(halfway - still.roots[i]));
        mostAlongTheta = std::max(mostAlongTheta, length(halfway - moved.roots[i]));
    }
    EXPECT_NEAR(mostAlongTheta, reach, 0.01 * reach);
    EXPECT_NEAR(mostAlongPhi, reach, 0.01 * reach);
}

TEST(Plant, DensityIsTheSameEverywhere) {
    Scalp s = scalp(0.0015, 0.5);
    const double perArea = 1 / (0.0015 * 0.0015);
    for (double theta = 20; theta < 160; theta += 35) {
        for (double phi = -180; phi < 180; phi += 60) {
            s.regions = {
                {{radians(theta), radians(theta + 35)}, {radians(phi), radians(phi + 60)}}};
            double area = 0;
            for (int i = 0; i < 100; ++i) {
                const double t = radians(theta + 35 * (i + 0.5) / 100);
                for (int k = 0; k < 60; ++k) {
                    const double p = radians(phi + 60 * (k + 0.5) / 60);
                    const Vec3d byTheta =
                        s.ellipsoid.point({t + 1e-5, p}) - s.ellipsoid.point({t - 1e-5, p});
                    const Vec3d byPhi =
                        s.ellipsoid.point({t, p + 1e-5}) - s.ellipsoid.point({t, p - 1e-5});
                    area += length(cross(byTheta, byPhi)) / 4e-10 * radians(0.35) * radians(1);
                }
            }
            const double expected = area * perArea;
            // The mean meridian is up to 9 % longer or shorter than the local one.
            EXPECT_NEAR(static_cast<double>(plant(s, 1)->size()) / expected, 1, 0.15)
                << theta << ' ' << phi;
        }
    }
}

TEST(Plant, MeetsACountWithinHalfAPercent) {
    for (const int count : {1, 7, 100, 999, 20000, 50000}) {
        Scalp s = scalp(0, 0.5);
        s.spacing.reset();
        s.count = count;
        s.regions = {{{0, radians(100)}, {}},
                     {{radians(90), radians(130)}, {radians(90), radians(270)}}};
        EXPECT_NEAR(static_cast<double>(plant(s, 9)->size()), count, 0.005 * count) << count;
    }
}

TEST(Plant, RegionsAreAUnionAndTestTheJitteredPlace) {
    Scalp s = scalp(0.002, 1);
    const RootRange top = {{0, radians(60)}, {}};
    const RootRange back = {{radians(30), radians(120)}, {radians(90), radians(270)}};
    const Follicles all = *plant(s, 4);
    s.regions = {top, back};
    const Follicles grown = *plant(s, 4);
    std::set<std::uint64_t> expected;
    for (std::size_t i = 0; i < all.size(); ++i) {
        const auto [theta, phi] = all.angles[i];
        const double turned = phi < 0 ? phi + 2 * pi : phi;
        const bool inTop = theta <= radians(60);
        const bool inBack = theta >= radians(30) && theta <= radians(120) &&
                            turned >= radians(90) && turned <= radians(270);
        if (inTop || inBack) expected.insert(all.keys[i]);
    }
    EXPECT_EQ(std::set<std::uint64_t>(grown.keys.begin(), grown.keys.end()), expected);
    EXPECT_EQ(grown.size(), expected.size());
}

// The border of a cap about the whorl of a sphere: its distance is known.
TEST(Plant, TowardsTheEdgeHairBecomesLess) {
    constexpr double radius = 0.1;
    Scalp s = scalp(0.0008, 1);
    s.ellipsoid = {{0, 0, 0}, {radius, radius, radius}, 0};
    s.regions = {{{0, radians(60)}, {}}};
    const Follicles all = *plant(s, 4);
    s.edge = 0.02;
    const Follicles grown = *plant(s, 4);
    ASSERT_EQ(grown.shares.size(), grown.size());

    std::vector<double> before(12);
    std::vector<double> after(12);
    const auto count = [&](const Follicles& follicles, std::vector<double>& byWay) {
        for (const EllipsoidAngles& at : follicles.angles) {
            const double way = radius * (radians(60) - at.theta) / s.edge;
            byWay[std::min<std::size_t>(11, static_cast<std::size_t>(10 * way))] += 1;
        }
    };
    count(all, before);
    count(grown, after);
    for (std::size_t i = 0; i < 12; ++i) {
        const double expected = std::min(1.0, (static_cast<double>(i) + 0.5) / 10);
        EXPECT_NEAR(after[i] / before[i], expected, 0.035) << i;
    }
    // Those that stay are the same.
    EXPECT_TRUE(std::ranges::includes(std::set(all.keys.begin(), all.keys.end()),
                                      std::set(grown.keys.begin(), grown.keys.end())));
}

// A narrow edge has no beads of hair on the border: the outermost quarter of it bears an eighth.
TEST(Plant, ANarrowEdgeIsAsSoft) {
    constexpr double radius = 0.1;
    Scalp s = scalp(0.0004, 1);
    s.ellipsoid = {{0, 0, 0}, {radius, radius, radius}, 0};
    s.regions = {{{0, radians(40)}, {}}};
    const auto outermost = [&](const Follicles& follicles) {
        return static_cast<double>(std::ranges::count_if(follicles.angles, [&](EllipsoidAngles at) {
            return radius * (radians(40) - at.theta) < 0.0005;
        }));
    };
    const double before = outermost(*plant(s, 4));
    s.edge = 0.002;
    EXPECT_NEAR(outermost(*plant(s, 4)) / before, 0.125, 0.05);
}

TEST(Plant, WithAnEdgeTheCountIsMetToo) {
    Scalp s = scalp(0, 0.5);
    s.spacing.reset();
    s.count = 5000;
    s.regions = {{{0, radians(80)}, {radians(-90), radians(90)}}};
    s.edge = 0.03;
    const Follicles follicles = *plant(s, 9);
    ASSERT_EQ(follicles.size(), 5000U);
    ASSERT_EQ(follicles.shares.size(), 5000U);
    EXPECT_LT(std::ranges::min(follicles.shares), 0.5F);
}

TEST(Plant, TheSeedDecidesAndNothingElse) {
    const Scalp s = scalp(0.003, 0.5);
    EXPECT_EQ(plant(s, 5)->roots, plant(s, 5)->roots);
    EXPECT_NE(plant(s, 5)->roots, plant(s, 6)->roots);
    const Follicles follicles = *plant(s, 5);
    EXPECT_EQ(std::set<std::uint64_t>(follicles.keys.begin(), follicles.keys.end()).size(),
              follicles.size());
}

TEST(Plant, RefusesMoreThanAMachineCanHold) {
    const auto refused = plant(scalp(1e-6, 0.5), 1);
    ASSERT_FALSE(refused);
    EXPECT_NE(refused.problems()[0].message.find("20,000,000"), std::string::npos);
}

}  // namespace
}  // namespace kushi
