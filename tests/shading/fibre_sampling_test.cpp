// SPDX-License-Identifier: Apache-2.0
#include "core/random.h"

#include <kushi/fibre.h>

#include <cmath>
#include <numbers>
#include <numeric>
#include <vector>

#include <gtest/gtest.h>

namespace kushi {
namespace {

constexpr double pi = std::numbers::pi;

double response(const Fibre& fibre, double absorption, double h, FibreDirection out,
                FibreDirection in) {
    const FibreLobes lobes = fibreResponse(fibre, absorption, h, out, in);
    return std::accumulate(lobes.begin(), lobes.end(), 0.0);
}

FibreSample sampleNumber(std::uint64_t i, const Fibre& fibre, double absorption, double h,
                         FibreDirection out) {
    return sampleFibre(fibre, absorption, h, out, uniform(mixKey(i, 1)), uniform(mixKey(i, 2)),
                       uniform(mixKey(i, 3)));
}

TEST(SampleFibre, GivesEverySampleOfAClearFibreTheWeightOne) {
    double mean = 0;
    constexpr std::uint64_t count = 100000;
    for (std::uint64_t i = 0; i < count; ++i) {
        const auto random = [&](std::uint64_t salt) { return uniform(mixKey(i, salt)); };
        const Fibre fibre = {.longitudinal = 0.1 + 0.8 * random(4),
                             .azimuthal = 0.1 + 0.8 * random(5),
                             .tilt = radians(4 * random(6))};
        const double h = 2 * random(7) - 1;
        const FibreDirection out = {2.6 * random(8) - 1.3, 6 * random(9)};
        const FibreSample sample = sampleNumber(i, fibre, 0, h, out);
        const double weight = response(fibre, 0, h, out, sample.in) / sample.pdf;
        ASSERT_NEAR(weight, 1, 0.01);
        mean += weight / count;
    }
    EXPECT_NEAR(mean, 1, 1e-3);
}

TEST(SampleFibre, SaysItsOwnDensity) {
    const FibreDirection out = {0.4, 1};
    for (std::uint64_t i = 0; i < 1000; ++i) {
        const FibreSample sample = sampleNumber(i, {}, 0.3, -0.6, out);
        EXPECT_NEAR(sample.pdf, fibrePdf({}, 0.3, -0.6, out, sample.in), 1e-6 * sample.pdf);
    }
}

// Light that comes as the square of a coordinate: by samples as by quadrature.
TEST(SampleFibre, FindsTheLightThatQuadratureFinds) {
    const auto light = [](FibreDirection in) {
        const double z = std::cos(in.theta) * std::sin(in.phi);
        return z * z;
    };
    for (const double bm : {0.2, 0.5, 0.8}) {
        for (const double bn : {0.4, 0.8}) {
            const Fibre fibre = {.longitudinal = bm, .azimuthal = bn};
            const FibreDirection out = {0.5, 0.8};
            const double h = 0.35;
            double sampled = 0;
            constexpr std::uint64_t count = 65536;
            for (std::uint64_t i = 0; i < count; ++i) {
                const FibreSample sample = sampleNumber(i, fibre, 0.25, h, out);
                sampled += light(sample.in) * response(fibre, 0.25, h, out, sample.in) /
                           sample.pdf / count;
            }
            double truth = 0;
            constexpr int rows = 120;
            constexpr int columns = 240;
            for (int i = 0; i < rows; ++i) {
                for (int j = 0; j < columns; ++j) {
                    const FibreDirection in = {pi * ((i + 0.5) / rows - 0.5),
                                               2 * pi * (j + 0.5) / columns};
                    truth += light(in) * response(fibre, 0.25, h, out, in) * std::cos(in.theta);
                }
            }
            truth *= pi / rows * 2 * pi / columns;
            EXPECT_NEAR(sampled / truth, 1, 0.02) << bm << " " << bn;
        }
    }
}

// Pearson's chi-square of samples counted in cells of sin(theta) and phi.
TEST(SampleFibre, IsDistributedAsItsDensity) {
    for (const Fibre& fibre : {Fibre{}, Fibre{.longitudinal = 0.5, .azimuthal = 0.8},
                               Fibre{.longitudinal = 0.9, .azimuthal = 1.0}}) {
        const FibreDirection out = {0.7, 0.2};
        constexpr int rows = 16;
        constexpr int columns = 24;
        constexpr int fine = 24;  // steps of the quadrature in a cell, each way
        constexpr std::uint64_t count = 200000;
        const double h = -0.5;
        std::vector<double> counted(rows * columns);
        for (std::uint64_t i = 0; i < count; ++i) {
            const FibreDirection in = sampleNumber(i, fibre, 0.25, h, out).in;
            const double row = (std::sin(in.theta) + 1) / 2 * rows;
            const double turn = in.phi / (2 * pi);
            const double column = (turn - std::floor(turn)) * columns;
            const auto cell = std::min(rows - 1, static_cast<int>(row)) * columns +
                              std::min(columns - 1, static_cast<int>(column));
            ++counted[static_cast<std::size_t>(cell)];
        }
        double chi = 0;
        int cells = 0;
        double rareCounted = 0;
        double rareExpected = 0;
        for (int cell = 0; cell < rows * columns; ++cell) {
            const int row = cell / columns;
            const int column = cell % columns;
            double expected = 0;
            for (int i = 0; i < fine; ++i) {
                for (int j = 0; j < fine; ++j) {
                    const double sine = 2 * (row + (i + 0.5) / fine) / rows - 1;
                    const double phi = 2 * pi * (column + (j + 0.5) / fine) / columns;
                    expected += fibrePdf(fibre, 0.25, h, out, {std::asin(sine), phi});
                }
            }
            expected *= static_cast<double>(count) * 2 / rows * 2 * pi / columns / (fine * fine);
            const double found = counted[static_cast<std::size_t>(cell)];
            if (expected < 8) {
                rareCounted += found;
                rareExpected += expected;
                continue;
            }
            chi += (found - expected) * (found - expected) / expected;
            ++cells;
        }
        // Within four standard deviations of a chi-square with so many degrees of freedom.
        EXPECT_LT(chi, cells + 4 * std::sqrt(2.0 * cells)) << fibre.azimuthal;
        EXPECT_GT(chi, cells - 4 * std::sqrt(2.0 * cells)) << fibre.azimuthal;
        EXPECT_NEAR(rareCounted, rareExpected, 5 * std::sqrt(rareExpected) + 1);
    }
}

}  // namespace
}  // namespace kushi
