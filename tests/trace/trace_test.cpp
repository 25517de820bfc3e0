// SPDX-License-Identifier: Apache-2.0
#include "trace/brightness.h"
#include "trace/test_scene.h"

#include <atomic>
#include <cstring>
#include <functional>
#include <limits>

#include <gmock/gmock.h>

namespace kushi {
namespace {

using namespace test;

const Camera camera = cameraAt({1.2F, 0.5F, 1});

Result<Traced> traced(const Strands& strands, const Mesh& head, const TraceOptions& options) {
    const std::vector<Rgb> skin(head.vertices.size(), {0.6F, 0.5F, 0.4F});
    return trace(strands, head, skin, studioLights(), camera, {}, options);
}

bool sameBytes(const Traced& a, const Traced& b) {
    return a.image.pixels.size() == b.image.pixels.size() &&
           std::memcmp(a.image.pixels.data(), b.image.pixels.data(),
                       a.image.pixels.size() * sizeof(Rgb)) == 0 &&
           a.alpha == b.alpha && a.noise == b.noise && a.samples == b.samples;
}

TEST(Trace, GivesTheSameBytesFromAnyNumberOfThreads) {
    TraceOptions options = small(40);
    options.width = 70;
    options.height = 45;
    options.noise = 0.1F;
    options.threads = 1;
    const Result<Traced> one = traced(hairsOnBall(2000), ball(), options);
    ASSERT_TRUE(one.ok());
    EXPECT_LT(one->samples, 40);
    for (const int threads : {2, 3, 0}) {
        options.threads = threads;
        EXPECT_TRUE(sameBytes(*one, *traced(hairsOnBall(2000), ball(), options))) << threads;
    }
    options.seed = 1;
    EXPECT_FALSE(sameBytes(*one, *traced(hairsOnBall(2000), ball(), options)));
}

TEST(Trace, CoversWhatIsThereAndShowsTheBackgroundElsewhere) {
    TraceOptions options = small(64);
    options.background = {0.2F, 0.4F, 0.8F};
    const Result<Traced> nothing = traced({}, {}, options);
    ASSERT_TRUE(nothing.ok());
    EXPECT_THAT(nothing->alpha, testing::Each(0.0F));
    EXPECT_NEAR(nothing->image.at(3, 3).b, 0.8, 1e-6);
    EXPECT_EQ(nothing->noise, 0);

    const Result<Traced> head = traced({}, ball(), options);
    ASSERT_TRUE(head.ok());
    EXPECT_EQ(head->alpha[10 * 24 + 12], 1);
    EXPECT_EQ(head->alpha[0], 0);
    EXPECT_EQ(head->image.at(0, 0), nothing->image.at(0, 0));
    // A ball of 5 cm from 1.64 m, of pixels that are a two hundredth of a radian.
    float covered = 0;
    for (const float alpha : head->alpha)
        covered += alpha;
    const double radius = std::asin(0.05 / length(camera.eye)) / 0.1 * 20;
    EXPECT_NEAR(covered, 3.14159 * radius * radius, 0.01 * covered);

    const Strands strands = hairsOnBall(500);
    const Result<Traced> hair = traced(strands, {}, options);
    ASSERT_TRUE(hair.ok());
    covered = 0;
    for (const float alpha : hair->alpha)
        covered += alpha;
    // Hardly any lies behind another.
    const Vec3f view = normalized(camera.eye);
    const float pixel = length(camera.eye) * 0.1F / 20;
    float truth = 0;
    for (std::size_t i = 0; i < strands.size(); ++i) {
        const auto nodes = strands.strand(i);
        for (std::size_t j = 0; j + 1 < nodes.size(); ++j)
            truth += length(cross(nodes[j + 1] - nodes[j], view)) * usualDiameter / (pixel * pixel);
    }
    EXPECT_NEAR(covered, truth, 0.12F * truth);
}

TEST(Trace, MakesLessNoiseOfMoreSamples) {
    const Strands strands = hairsOnBall(2000);
    const auto difference = [&](int samples) {
        TraceOptions options = small(samples);
        const Traced a = *traced(strands, ball(), options);
        options.seed = 9;
        const Traced b = *traced(strands, ball(), options);
        double sum = 0;
        for (std::size_t i = 0; i < a.image.pixels.size(); ++i) {
            const double d = static_cast<double>(a.image.pixels[i].g - b.image.pixels[i].g);
            sum += d * d;
        }
        const double found = std::sqrt(sum / 2 / static_cast<double>(a.image.pixels.size())) /
                             static_cast<double>(meanOf(a.image).g);
        return found;
    };
    EXPECT_LT(difference(256), 0.35 * difference(16));
}

// Against what pictures of different seeds differ by.
TEST(Trace, TellsItsNoise) {
    const Strands strands = hairsOnBall(2000);
    for (const int samples : {16, 24, 64, 256}) {
        constexpr int pictures = 8;
        double told = 0;
        std::vector<Image> images;
        for (int i = 0; i < pictures; ++i) {
            TraceOptions options = small(samples);
            options.seed = static_cast<std::uint64_t>(i);
            const Traced one = *traced(strands, ball(), options);
            told += one.noise * one.noise / pictures;
            images.push_back(one.image);
        }
        double variance = 0;
        double mean = 0;
        const std::size_t pixels = images[0].pixels.size();
        for (std::size_t p = 0; p < pixels; ++p) {
            double sum = 0;
            double squares = 0;
            for (const Image& image : images) {
                const auto bright = static_cast<double>(luminance(image.pixels[p]));
                sum += bright;
                squares += bright * bright;
            }
            variance += (squares - sum * sum / pictures) / (pictures - 1);
            mean += sum / pictures;
        }
        const double truth = std::sqrt(variance / static_cast<double>(pixels)) /
                             (mean / static_cast<double>(pixels));
        EXPECT_NEAR(std::sqrt(told) / truth, 1.03, 0.1) << samples;
    }
}

TEST(Trace, StopsWhereTheNoiseIsLow) {
    TraceOptions options = small(4096);
    options.noise = 0.05F;
    const Result<Traced> result = traced(hairsOnBall(1000), ball(), options);
    ASSERT_TRUE(result.ok());
    EXPECT_LT(result->samples, 2000);
    EXPECT_GE(result->samples, 16);
    EXPECT_LT(result->noise, 0.06);
}

TEST(Trace, BearsWhatIsNotANumber) {
    constexpr float nan = std::numeric_limits<float>::quiet_NaN();
    Strands strands = hairsOnBall(300);
    strands.add(std::vector<Vec3f>{{0, 0, 0.06F}}, 1);
    strands.add(std::vector<Vec3f>{{0, 0, 0.06F}, {0, 0, 0.06F}}, 2);
    strands.add(std::vector<Vec3f>{{nan, 0, 0.06F}, {0, 0.02F, 0.07F}, {0, 0.03F, 0.08F}}, 3);
    strands.add(std::vector<Vec3f>{}, 4);
    strands.colors.assign(strands.nodes.size(), {0.3F, nan, -1});
    strands.diameters.assign(strands.nodes.size(), 1e-3F);
    strands.diameters[5] = nan;
    strands.diameters[9] = 0;
    Mesh head = ball();
    head.vertices[40].x = nan;
    head.normals[50] = {nan, nan, nan};
    head.normals[60] = {};
    std::vector<Rgb> skin(head.vertices.size(), {0.5F, nan, 7});
    const Result<Traced> result = trace(strands, head, skin, studioLights(), camera, {}, small(32));
    ASSERT_TRUE(result.ok());
    for (const Rgb pixel : result->image.pixels) {
        EXPECT_TRUE(pixel.r >= 0 && std::isfinite(pixel.r));
        EXPECT_TRUE(pixel.g >= 0 && std::isfinite(pixel.g));
        EXPECT_TRUE(pixel.b >= 0 && std::isfinite(pixel.b));
    }
}

TEST(Trace, ReportsProgressUpToTheEnd) {
    TraceOptions options = small(1);
    options.width = 64;
    options.threads = 1;
    double last = 0;
    options.progress = [&](double share) {
        EXPECT_GT(share, last);
        last = share;
    };
    ASSERT_TRUE(traced({}, ball(), options).ok());
    EXPECT_EQ(last, 1);
}

TEST(Trace, SaysWhatIsWrong) {
    const Mesh head = ball();
    const auto problem =
        [&](const std::function<void(TraceOptions&, TraceLook&, Strands&, std::vector<Rgb>&,
                                     Camera&, Lights&)>& spoil) {
            TraceOptions options = small(1);
            TraceLook look;
            Strands strands = hairsOnBall(2);
            std::vector<Rgb> skin(head.vertices.size());
            Camera view = camera;
            Lights lights = studioLights();
            spoil(options, look, strands, skin, view, lights);
            const Result<Traced> result = trace(strands, head, skin, lights, view, look, options);
            return result.ok() ? std::string() : result.problems()[0].message;
        };
    EXPECT_EQ(problem([](auto&...) {}), "");
    using testing::HasSubstr;
    EXPECT_EQ(problem([](auto& o, auto&...) { o.width = 0; }), "width is 0, expected 1 to 16384");
    EXPECT_THAT(problem([](auto& o, auto&...) { o.height = 20000; }), HasSubstr("height is 20000"));
    EXPECT_THAT(problem([](auto& o, auto&...) { o.samplesPerPixel = 0; }), HasSubstr("samples"));
    EXPECT_THAT(problem([](auto& o, auto&...) { o.bounces = -1; }), HasSubstr("bounces"));
    EXPECT_THAT(problem([](auto& o, auto&...) { o.noise = std::nanf(""); }), HasSubstr("noise"));
    EXPECT_EQ(problem([](auto&, auto& l, auto&...) { l.fibre.eta = 0.5; }),
              "the fibre's index of refraction is 0.5, expected 1.001 to 4");
    EXPECT_THAT(problem([](auto&, auto& l, auto&...) { l.fibre.azimuthal = 0; }),
                HasSubstr("azimuthal"));
    EXPECT_THAT(problem([](auto&, auto&, auto& s, auto&...) { s.colors.resize(3); }),
                HasSubstr("there are 3 hair colours, expected one for each of the 14 nodes"));
    EXPECT_THAT(problem([](auto&, auto&, auto& s, auto&...) { s.diameters.resize(1); }),
                HasSubstr("diameters"));
    EXPECT_THAT(problem([](auto&, auto&, auto&, auto& k, auto&...) { k.resize(5); }),
                HasSubstr("skin colours"));
    EXPECT_THAT(problem([](auto&, auto&, auto&, auto&, auto& c, auto&) { c.eye = c.target; }),
                HasSubstr("camera"));
    EXPECT_THAT(
        problem([](auto&, auto&, auto&, auto&, auto&, auto& l) { l.distant[0].direction = {}; }),
        HasSubstr("light"));
}

}  // namespace
}  // namespace kushi
