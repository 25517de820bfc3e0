// SPDX-License-Identifier: Apache-2.0
#include "core/random.h"
#include "shading/fibre_model.h"

#include <kushi/fibre.h>

#include <cmath>
#include <numeric>

#include <gtest/gtest.h>

namespace kushi {
namespace {

constexpr double pi = std::numbers::pi;

/// Where f is largest of evenly spaced places in [low, high], and how large.
struct Peak {
    double at = 0, value = 0;
};
template <class F>
Peak peakOf(double low, double high, int steps, F f) {
    Peak best;
    for (int i = 0; i <= steps; ++i) {
        const double x = low + (high - low) * i / steps;
        const double value = f(x);
        if (value > best.value) best = {x, value};
    }
    return best;
}

double sum(const FibreLobes& lobes) {
    return std::accumulate(lobes.begin(), lobes.end(), 0.0);
}

Fibre rough(double longitudinal, double azimuthal, double tilt = 0) {
    return {.longitudinal = longitudinal, .azimuthal = azimuthal, .tilt = tilt};
}

TEST(BesselI0, IsThatOfTheStandardLibrary) {
    for (int i = 0; i < 160; ++i) {
        const double x = i < 110 ? 0.37 * i : 13 * (i - 107);
        const double truth = std::exp(-x) * std::cyl_bessel_i(0.0, x);
        EXPECT_NEAR(besselI0Scaled(x) / truth, 1, 1e-12) << x;
        EXPECT_NEAR(besselI0Scaled(static_cast<float>(x)) / truth, 1, 2e-6) << x;
    }
    EXPECT_NEAR(besselI0Scaled(1e6), 1 / std::sqrt(2e6 * pi), 1e-9);
}

// Against an independent transcription of the published model in double precision, which has the
// tilt the other way round.
TEST(FibreResponse, IsThatOfTheTable) {
    struct Row {
        double h, thetaOut, phiOut, thetaIn, phiIn;
        FibreLobes lobes;
        double sum;
    };
    const std::vector<Row> table = {
        {-0.5,
         0.20,
         0.00,
         -0.20,
         0.1,
         {0.000174917, 3.78528e-10, 0.00485566, 6.23143e-05},
         0.00509289},
        {-0.5, 0.20, 0.00, -0.20, pi, {9.78599e-09, 0.409930, 2.04966e-12, 6.23143e-05}, 0.409993},
        {-0.5,
         0.60,
         0.30,
         -0.50,
         2.5,
         {4.09426e-05, 5.79724e-05, 3.54678e-10, 8.66527e-05},
         0.000185568},
        {-0.5,
         0.00,
         0.00,
         0.00,
         0,
         {7.27520e-05, 8.14992e-10, 0.00866061, 6.04861e-05},
         0.00879385},
        {0.0, 0.20, 0.00, -0.20, 0.1, {0.113797, 6.81517e-11, 0.0203830, 5.28288e-05}, 0.134233},
        {0.0, 0.20, 0.00, -0.20, pi, {1.22905e-12, 3.20746, 2.20143e-13, 5.28288e-05}, 3.20751},
        {0.0,
         0.60,
         0.30,
         -0.50,
         2.5,
         {4.70478e-09, 0.00310508, 7.87066e-10, 6.26802e-05},
         0.00316776},
        {0.0, 0.00, 0.00, 0.00, 0, {0.133921, 2.84629e-11, 0.0235585, 5.22147e-05}, 0.157532},
        {0.8,
         0.20,
         0.00,
         -0.20,
         0.1,
         {4.93524e-08, 5.55807e-08, 0.0237342, 0.000160489},
         0.0238948},
        {0.8, 0.20, 0.00, -0.20, pi, {1.47213e-05, 0.0160483, 4.39969e-12, 0.000160489}, 0.0162235},
        {0.8, 0.60, 0.30, -0.50, 2.5, {7.36686e-09, 2.23454, 2.35239e-09, 0.000278252}, 2.23481},
        {0.8, 0.00, 0.00, 0.00, 0, {1.10766e-07, 2.06960e-08, 0.00953390, 0.000150149}, 0.00968419},
    };
    for (const Row& row : table) {
        const FibreLobes lobes =
            fibreResponse({.tilt = radians(-2)}, 0.25, row.h, {row.thetaOut, row.phiOut},
                          {row.thetaIn, row.phiIn});
        for (std::size_t p = 0; p < 4; ++p)
            EXPECT_NEAR(lobes[p] / row.lobes[p], 1, 1e-4) << row.h << " " << row.sum << " " << p;
        EXPECT_NEAR(sum(lobes) / row.sum, 1, 1e-4);
    }
}

// White furnace: a clear fibre sends on all light, wherever across it is hit.
TEST(FibreResponse, OfAClearFibreIntegratesToOne) {
    for (const double bm : {0.1, 0.3, 0.5, 0.7, 0.9}) {
        for (const double bn : {0.1, 0.3, 0.5, 0.7, 0.9}) {
            for (const double h : {-0.97, 0.0, 0.4}) {
                const double tilt = h == 0 ? radians(2) : 0;
                const Fibre fibre = rough(bm, bn, tilt);
                const double thetaOut = h == 0.4 ? 1.3 : 0.2;
                constexpr int rows = 160;
                constexpr int columns = 360;
                double total = 0;
                for (int i = 0; i < rows; ++i) {
                    const double theta = pi * ((i + 0.5) / rows - 0.5);
                    for (int j = 0; j < columns; ++j) {
                        const double phi = 2 * pi * (j + 0.5) / columns;
                        total += std::cos(theta) *
                                 sum(fibreResponse(fibre, 0, h, {thetaOut, 0.3}, {theta, phi}));
                    }
                }
                total *= pi / rows * 2 * pi / columns;
                EXPECT_NEAR(total, 1, 1e-3) << bm << " " << bn << " " << h;
            }
        }
    }
}

TEST(FibreResponse, PeaksWhereTiltedScalesReflect) {
    // Nearly smooth: roughness, with the cosine of M, drives the peaks apart a little.
    const Fibre fibre = rough(0.1, 0.3, radians(2));
    const auto peak = [&](std::size_t lobe, double thetaOut, double phi) {
        return degrees(peakOf(-1, 1, 20000, [&](double theta) {
                           return fibreResponse(fibre, 0.25, 0, {thetaOut, 0}, {theta, phi})[lobe];
                       }).at);
    };
    EXPECT_NEAR(peak(0, 0, 0), -4, 0.05);
    EXPECT_NEAR(peak(1, 0, pi), 2, 0.05);
    EXPECT_NEAR(peak(2, 0, 0), 8, 0.25);
    EXPECT_NEAR(peak(0, radians(10), 0), -14, 0.1);
}

TEST(FibreResponse, IsFiniteAndNeverNegative) {
    const auto expectFine = [](const FibreLobes& lobes) {
        for (const double value : lobes) {
            EXPECT_TRUE(std::isfinite(value)) << value;
            EXPECT_GE(value, 0);
        }
    };
    for (const double roughness : {0.02, 0.1, 0.5, 1.0}) {
        for (const double h : {-1.0, -0.999999, 0.0, 1.0}) {
            for (const double out : {-pi / 2, -1.57, 0.0, 1.5707, pi / 2}) {
                for (const double in : {-pi / 2, -1.2, 0.0, pi / 2}) {
                    for (const double sigma : {0.0, 3.0, 1e4}) {
                        const Fibre fibre = rough(roughness, roughness, 0.05);
                        expectFine(fibreResponse(fibre, sigma, h, {out, 0}, {in, 3}));
                        const FibreView<float> view(FibreModel<float>(fibre), static_cast<float>(h),
                                                    static_cast<float>(std::sin(out)),
                                                    static_cast<float>(std::cos(out)));
                        for (const float value : view.attenuations(static_cast<float>(sigma)))
                            EXPECT_TRUE(value >= 0 && value <= 1)
                                << value << " " << h << " " << out;
                    }
                }
            }
        }
    }
    // The direction at which a bug of pbrt's gave no number.
    const Vec3d out = {0.54986966, 0.03359017, 0.83457476};
    const Vec3d in = {-0.37383357, -0.91920084, 0.12376696};
    expectFine(fibreResponse(rough(0.1, 0.1), 0, -1, {std::asin(out.x), std::atan2(out.z, out.y)},
                             {std::asin(in.x), std::atan2(in.z, in.y)}));
}

TEST(FibreResponse, InFloatsIsThatInDoubles) {
    for (std::uint64_t i = 0; i < 20000; ++i) {
        const auto random = [&](std::uint64_t salt) { return uniform(mixKey(i, salt)); };
        const Fibre fibre = {.longitudinal = 0.1 + 0.8 * random(1),
                             .azimuthal = 0.1 + 0.8 * random(2)};
        const FibreModel<double> model(fibre);
        const FibreModel<float> fast(fibre);
        const double h = 1.98 * random(3) - 0.99;
        const double out = 2.8 * random(4) - 1.4;
        const double in = 2.8 * random(5) - 1.4;
        const double phi = 2 * pi * random(6);
        const FibreView<double> view(model, h, std::sin(out), std::cos(out));
        const FibreView<float> fastView(fast, static_cast<float>(h),
                                        static_cast<float>(std::sin(out)),
                                        static_cast<float>(std::cos(out)));
        const auto truth = view.spread({std::sin(in), std::cos(in), phi});
        const auto values =
            fastView.spread({static_cast<float>(std::sin(in)), static_cast<float>(std::cos(in)),
                             static_cast<float>(phi)});
        const auto shares = view.attenuations(0.4);
        const auto fastShares = fastView.attenuations(0.4F);
        for (std::size_t p = 0; p < 4; ++p) {
            EXPECT_NEAR(values[p], truth[p], 1e-3 * truth[p] + 1e-6);
            EXPECT_NEAR(fastShares[p], shares[p], 1e-4 * shares[p] + 1e-7);
        }
    }
}

struct AlbedoRow {
    double absorption, total, r, tt, trt, rest;
};

TEST(FibreAlbedo, IsThatOfTheTable) {
    for (const AlbedoRow& row :
         std::initializer_list<AlbedoRow>{{0, 1.0000, 0.0750, 0.8618, 0.0557, 0.0076},
                                          {0.1257, 0.7960, 0.0750, 0.6818, 0.0355, 0.0037},
                                          {0.2091, 0.6874, 0.0750, 0.5838, 0.0263, 0.0024},
                                          {0.4110, 0.4897, 0.0750, 0.4011, 0.0128, 0.0008},
                                          {0.5447, 0.3962, 0.0750, 0.3129, 0.0080, 0.0004},
                                          {0.9061, 0.2375, 0.0750, 0.1602, 0.0022, 0.0001},
                                          {1.7810, 0.1071, 0.0750, 0.0320, 0.0001, 0.0000},
                                          {3.3520, 0.0768, 0.0750, 0.0018, 0.0000, 0.0000}}) {
        const FibreLobes albedo = fibreAlbedo({}, row.absorption, 0);
        EXPECT_NEAR(sum(albedo), row.total, 6e-5) << row.absorption;
        EXPECT_NEAR(albedo[0], row.r, 6e-5);
        EXPECT_NEAR(albedo[1], row.tt, 6e-5);
        EXPECT_NEAR(albedo[2], row.trt, 6e-5);
        EXPECT_NEAR(albedo[3], row.rest, 6e-5);
    }
}

TEST(FibreAlbedo, OfAClearFibreIsOneFromEverywhere) {
    const FibreLobes slanted = fibreAlbedo({}, 0, 0.8);
    EXPECT_NEAR(slanted[0], 0.1120, 6e-5);
    EXPECT_NEAR(slanted[1], 0.7990, 6e-5);
    const FibreLobes grazing = fibreAlbedo({}, 0, 1.3);
    EXPECT_NEAR(grazing[0], 0.3496, 6e-5);
    EXPECT_NEAR(grazing[2], 0.1366, 6e-5);
    for (int i = -5; i <= 5; ++i)
        EXPECT_NEAR(sum(fibreAlbedo({}, 0, 0.31 * i)), 1, 1e-9) << i;
}

TEST(Fresnel, ReflectsWhatGlassDoes) {
    EXPECT_NEAR(fresnel(1.0, 1.55), 0.04652, 1e-5);
    EXPECT_NEAR(fresnel(0.0, 1.55), 1, 1e-12);
    EXPECT_NEAR(fresnel(0.5, 1.0), 0, 1e-12);
}

// Light that is reflected inside once leaves a smooth fibre no farther around than 18.62 degrees
// either side of the way it came, from h = sqrt((4 - eta^2) / 3) = 0.7297.
TEST(FibreResponse, HasTheCausticOfAGlassCylinder) {
    const Fibre smooth = rough(0.3, 0.02);
    const Peak farthest = peakOf(0, 1, 200, [&](double h) {
        return std::abs(peakOf(-0.6, 0.6, 600, [&](double phi) {
                            return fibreResponse(smooth, 0.25, h, {0, 0}, {0, phi})[2];
                        }).at);
    });
    EXPECT_NEAR(degrees(farthest.value), 18.62, 0.2);
    EXPECT_NEAR(farthest.at, 0.7297, 0.04);
}

TEST(FibreModel, IsTiltedMoreAsAFibreOfThatTilt) {
    const FibreModel<double> model(Fibre{.tilt = 0.035});
    for (const double more : {-0.05, 0.0, 0.02}) {
        const FibreModel<double> other(Fibre{.tilt = 0.035 + more});
        for (const double theta : {-1.5, -0.4, 0.0, 0.9}) {
            const auto found = model.outgoing(std::sin(theta), std::cos(theta), more);
            const auto truth = other.outgoing(std::sin(theta), std::cos(theta), 0);
            for (std::size_t p = 0; p < 4; ++p) {
                EXPECT_NEAR(found.sine[p], truth.sine[p], 1e-12) << p;
                EXPECT_NEAR(found.cosine[p], truth.cosine[p], 1e-12) << p;
            }
        }
    }
}

}  // namespace
}  // namespace kushi
