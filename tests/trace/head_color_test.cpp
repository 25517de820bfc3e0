// SPDX-License-Identifier: Apache-2.0
// A colour is that which a head of such hair shows, traced or drawn.
#include "core/random.h"

#include <kushi/draw.h>
#include <kushi/shadows.h>
#include <kushi/trace.h>

#include <array>
#include <cmath>
#include <numbers>

#include <gtest/gtest.h>

namespace kushi {
namespace {

constexpr std::size_t hairs = 6000;
constexpr float diameter = 4e-4F;  // each stands for many

Mesh skull() {
    return ellipsoidMesh({.center = {}, .semiAxes = {0.09, 0.09, 0.09}}, 60);
}

/// Hair that hangs about a skull in layers 1.4 cm deep, and leans a little to either side.
Strands wig() {
    Strands strands;
    constexpr int segments = 12;
    for (std::uint64_t i = 0; i < hairs; ++i) {
        const double height = 1 - 1.1 * (static_cast<double>(i) + 0.5) / hairs;
        const double side = static_cast<double>(i) * std::numbers::pi * (3 - std::sqrt(5.0));
        const double lean = 0.15 * uniformSigned(mixKey(i, 1));
        const double layer = 0.092 + 0.014 * uniform(mixKey(i, 2));
        std::vector<Vec3f> nodes;
        for (int j = 0; j <= segments; ++j) {
            const double share = static_cast<double>(j) / segments;
            const double down = std::min(std::acos(height) + 1.6 * share, 2.5);
            const double out = 0.09 + (layer - 0.09) * std::min(1.0, 4 * share);
            const double turn = side + lean * share;
            nodes.push_back((out * Vec3d{std::sin(down) * std::cos(turn), std::cos(down),
                                         std::sin(down) * std::sin(turn)})
                                .as<float>());
        }
        strands.add(nodes, i);
    }
    strands.diameters.assign(strands.nodes.size(), diameter);
    return strands;
}

const Camera inFront = {
    .eye = {1.5F, 0.1F, 0.2F}, .target = {0, 0.02F, 0}, .verticalFieldOfView = 0.07F};
constexpr int side = 24;

Rgb meanOf(const Image& image) {
    Rgb sum;
    for (const Rgb pixel : image.pixels)
        sum += pixel;
    return sum * (1.0F / static_cast<float>(image.pixels.size()));
}

Rgb traced(Rgb color) {
    const Mesh head = skull();
    const std::vector<Rgb> skin(head.vertices.size(), 0.6F * color);
    TraceOptions options;
    options.width = side;
    options.height = side;
    options.background = {};
    options.samplesPerPixel = 32;
    TraceLook look;
    look.color = color;
    return meanOf(trace(wig(), head, skin, portraitLights(), inFront, look, options)->image);
}

Rgb drawn(Rgb color) {
    const Lights lights = portraitLights();
    const Strands hair = wig();
    Mesh head = skull();
    const Shadows shadows(hair, head, lights);
    head.colors =
        shadeMatt(head, lights, std::vector<Rgb>(head.vertices.size(), 0.6F * color), shadows);
    std::vector<Rgb> colors(hair.nodes.size());
    shade(hair, lights, shadows, {.color = color}, inFront.eye, colors);
    DrawOptions options;
    options.width = side;
    options.height = side;
    options.background = {};
    options.stroke = Stroke::Sampled;
    return meanOf(draw(hair, colors, head, inFront, options));
}

struct Named {
    const char* name;
    Rgb color;
};
/// Some of the names of styles, from dark to light.
constexpr std::array names = {
    Named{"dark brown", {0.06F, 0.032F, 0.02F}}, Named{"brown", {0.12F, 0.065F, 0.036F}},
    Named{"red", {0.26F, 0.075F, 0.024F}},       Named{"light brown", {0.22F, 0.13F, 0.072F}},
    Named{"grey", {0.30F, 0.29F, 0.28F}},        Named{"blond", {0.45F, 0.30F, 0.15F}}};

double lightness(Rgb c) {
    return 0.2126 * static_cast<double>(c.r) + 0.7152 * static_cast<double>(c.g) +
           0.0722 * static_cast<double>(c.b);
}

/// How light it is, and its hue: how much more red than green.
void expectAbout(Rgb shown, const Named& asked) {
    const double share = lightness(shown) / lightness(asked.color);
    EXPECT_GT(share, 0.75) << asked.name;
    EXPECT_LT(share, 1.2) << asked.name;
    const float hue = shown.r / shown.g / (asked.color.r / asked.color.g);
    EXPECT_GT(hue, 0.82F) << asked.name;
    EXPECT_LT(hue, 1.25F) << asked.name;
}

TEST(HeadOfHair, DrawnShowsTheColourAskedFor) {
    for (const Named& asked : names)
        expectAbout(drawn(asked.color), asked);
}

TEST(HeadOfHair, TracedShowsTheColourAskedFor) {
    for (const Named& asked : names)
        expectAbout(traced(asked.color), asked);
}

}  // namespace
}  // namespace kushi
