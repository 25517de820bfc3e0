// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "core/random.h"

#include <kushi/trace.h>

#include <cmath>
#include <vector>

namespace kushi::test {

inline constexpr Rgb black = {0, 0, 0};
inline constexpr Rgb white = {1, 1, 1};

/// A clear fibre, a matt skin.
inline TraceLook whiteLook() {
    return {.color = white, .diameter = 1e-3F, .skinGloss = 0};
}

inline Lights onlyDome(Rgb color = white) {
    return {.ambient = color, .distant = {}};
}

/// From `eye` to the origin, a tenth of a radian high.
inline Camera cameraAt(Vec3f eye) {
    return {.eye = eye, .target = {}, .verticalFieldOfView = 0.1F};
}

/// A ball of 5 cm about the origin.
inline Mesh ball() {
    return ellipsoidMesh({.center = {}, .semiAxes = {0.05, 0.05, 0.05}}, 40);
}

/// Curved hairs that stand about on that ball.
inline Strands hairsOnBall(std::size_t count, std::size_t segments = 6) {
    Strands strands;
    for (std::uint64_t i = 0; i < count; ++i) {
        const double z = uniformSigned(mixKey(i, 1));
        const double turn = 7 * uniform(mixKey(i, 2));
        const double r = std::sqrt(1 - z * z);
        const Vec3d out = {r * std::cos(turn), r * std::sin(turn), z};
        std::vector<Vec3f> nodes;
        for (std::size_t j = 0; j <= segments; ++j) {
            const double s = 0.03 * static_cast<double>(j) / static_cast<double>(segments);
            nodes.push_back((0.05 * out + s * out + Vec3d{0, -12 * s * s, 0}).as<float>());
        }
        strands.add(nodes, i);
    }
    return strands;
}

inline TraceOptions small(int samples) {
    TraceOptions options;
    options.width = 24;
    options.height = 20;
    options.samplesPerPixel = samples;
    options.background = black;
    options.clamp = 0;
    return options;
}

inline Rgb meanOf(const Image& image) {
    Rgb sum;
    for (const Rgb pixel : image.pixels)
        sum += pixel;
    return sum * (1 / static_cast<float>(image.pixels.size()));
}

}  // namespace kushi::test
