// SPDX-License-Identifier: Apache-2.0
#include <kushi/draw.h>

#include <cmath>
#include <vector>

#include <gtest/gtest.h>

namespace kushi {
namespace {

constexpr int side = 96;
constexpr Rgb grey = {0.3F, 0.3F, 0.3F};

/// A grey strand across a white picture of 96 pixels, so many of them wide.
Image strandOf(float pixels, Stroke stroke, int supersample) {
    const float pixel = 2 * std::tan(0.05F) / side;  // m, a metre away
    Strands strands;
    const std::vector<Vec3f> nodes = {{-0.2F, -0.13F, 0}, {0.01F, 0.001F, 0}, {0.2F, 0.12F, 0}};
    strands.add(nodes, 1);
    strands.diameters.assign(3, pixels * pixel);
    const Camera camera = {.eye = {0, 0, 1}, .target = {}, .verticalFieldOfView = 0.1F};
    DrawOptions options;
    options.width = side;
    options.height = side;
    options.stroke = stroke;
    options.supersample = supersample;
    options.background = {1, 1, 1};
    options.round = true;
    return draw(strands, std::vector<Rgb>(3, grey), {}, camera, options);
}

double darkness(const Image& image) {
    double sum = 0;
    for (const Rgb pixel : image.pixels)
        sum += 1 - static_cast<double>(pixel.g);
    return sum;
}

struct Extremes {
    float darkest = 1, lightest = 0;  ///< of pixels that are all strand
};

/// Along the middle column.
Extremes across(const Image& image, int margin) {
    int first = side;
    int last = 0;
    for (int y = 0; y < side; ++y) {
        if (image.at(side / 2, y).g > 0.9F) continue;
        first = std::min(first, y);
        last = y;
    }
    Extremes found;
    for (int y = first + margin; y <= last - margin; ++y) {
        found.darkest = std::min(found.darkest, image.at(side / 2, y).g);
        found.lightest = std::max(found.lightest, image.at(side / 2, y).g);
    }
    return found;
}

class Rounding : public testing::TestWithParam<std::pair<Stroke, int>> {};

TEST_P(Rounding, WideStrandsAreBrighterInTheMiddleAndAsBrightOnAverage) {
    const auto& [stroke, supersample] = GetParam();
    for (const float pixels : {6.0F, 13.0F, 31.5F}) {
        const Image image = strandOf(pixels, stroke, supersample);
        const Extremes found = across(image, stroke == Stroke::Sampled && supersample == 1 ? 0 : 1);
        EXPECT_GT(found.lightest, 1.2F * grey.g) << pixels;
        EXPECT_LT(found.lightest, 1.3F * grey.g) << pixels;
        EXPECT_LT(found.darkest, 0.85F * grey.g) << pixels;
        // Flat, it would take 0.7 from each pixel's white.
        const double length = side / std::cos(std::atan(0.125 / 0.2));
        EXPECT_NEAR(darkness(image) / (0.7 * length * static_cast<double>(pixels)), 1, 0.02)
            << pixels;
    }
}

TEST_P(Rounding, ThinStrandsAreFlat) {
    const auto& [stroke, supersample] = GetParam();
    const Image image = strandOf(1.98F, stroke, supersample);
    float darkest = 1;
    for (const Rgb pixel : image.pixels)
        darkest = std::min(darkest, pixel.g);
    EXPECT_NEAR(darkest, grey.g, 1e-4);
}

INSTANTIATE_TEST_SUITE_P(Strokes, Rounding,
                         testing::Values(std::pair(Stroke::Sampled, 4),
                                         std::pair(Stroke::Sampled, 1),
                                         std::pair(Stroke::Analytic, 1)));

}  // namespace
}  // namespace kushi
