// SPDX-License-Identifier: Apache-2.0
#include "trace/hair_band.h"

#include "core/random.h"

#include <gtest/gtest.h>

namespace kushi {
namespace {

TEST(FastMath, IsNearTheTruth) {
    for (int i = 0; i <= 4000; ++i) {
        const float x = static_cast<float>(i) / 2000 - 1;
        EXPECT_NEAR(fastAsin(x), std::asin(x), 7e-5) << x;
        const float y = -87.0F * static_cast<float>(i) / 4000;
        EXPECT_NEAR(fastExp(y) / std::exp(y), 1, 8e-6) << y;
    }
    EXPECT_LT(fastExp(-1000), 1e-37F);
    EXPECT_EQ(fastExp(0), 1);
}

TEST(HairBand, IsTheMeanOfItsPlaces) {
    for (std::uint64_t i = 0; i < 5000; ++i) {
        const auto random = [&](std::uint64_t salt) {
            return static_cast<float>(uniform(mixKey(i, salt)));
        };
        const Fibre fibre = {.longitudinal = 0.15 + 0.8 * static_cast<double>(random(1)),
                             .azimuthal = 0.2 + 0.7 * static_cast<double>(random(2))};
        const FibreModel<float> model(fibre);
        const float out = 2.6F * random(3) - 1.3F;
        const float in = 2.6F * random(4) - 1.3F;
        const FibreIncidence<float> incidence = {std::sin(in), std::cos(in), 9 * random(5) - 4};
        const Rgb absorption = {0.1F, 0.4F, random(6)};
        const Places places = i % 3 == 0 ? Places::one(0.7F) : Places::all(random(7));
        const float tilt = 0.06F * random(8) - 0.03F;
        const HairBand band(model, places, std::sin(out), std::cos(out), tilt, absorption,
                            {1, 1, 1});
        Rgb value;
        float pdf = 0;
        for (std::size_t k = 0; k < Places::count; ++k) {
            const FibreView<float> view(model, places.h(k), std::sin(out), std::cos(out), tilt);
            const auto spread = view.spread(incidence);
            const auto red = view.attenuations(absorption.r);
            const auto green = view.attenuations(absorption.g);
            const auto blue = view.attenuations(absorption.b);
            float sum = 0;
            for (std::size_t p = 0; p < 4; ++p)
                sum += luminance({red[p], green[p], blue[p]});
            for (std::size_t p = 0; p < 4; ++p) {
                const Rgb part = {red[p], green[p], blue[p]};
                value += (spread[p] / Places::count) * part;
                pdf += spread[p] / Places::count * luminance(part) / sum;
                EXPECT_NEAR(band.parts(k)[p].g, part.g, 1e-4);
                EXPECT_NEAR(band.shares(k)[p], luminance(part) / sum, 1e-4);
            }
        }
        const Response found = band.response(incidence);
        // The angle's small error matters where smooth fibres are dark.
        EXPECT_NEAR(found.value.r, value.r, 4e-3 * value.r + 1e-6);
        EXPECT_NEAR(found.value.b, value.b, 4e-3 * value.b + 1e-6);
        EXPECT_NEAR(found.pdf, pdf, 4e-3 * pdf + 1e-6);
    }
}

TEST(Places, CoverTheWholeWidth) {
    const Places places = Places::all(0.5F);
    EXPECT_NEAR(places.h(0), -0.875, 1e-6);
    EXPECT_NEAR(places.h(Places::count - 1), 0.875, 1e-6);
    EXPECT_EQ(Places::one(0.3F).h(5), 0.3F);
}

}  // namespace
}  // namespace kushi
