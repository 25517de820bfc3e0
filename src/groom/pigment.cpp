// SPDX-License-Identifier: Apache-2.0
#include <kushi/pigment.h>

#include <algorithm>
#include <cmath>

namespace kushi {

namespace {

// What hair shows without any light from inside: the reflection at its surface.
constexpr double sheen = 0.025;

/// Minus the logarithm of what comes from inside, by the root of sigma_a. Chiang et al. (2016), eq.
/// 9, has how it depends on roughness; the whole is what the path tracer shows.
double spreadOfColor(double b) {
    return 0.705 * (5.969 + b * (-0.215 + b * (2.532 + b * (-10.73 + b * (5.574 + b * 0.245)))));
}

}  // namespace

Rgb absorptionOfMelanin(float melanin, float redness) {
    constexpr Rgb eumelanin = {0.419F, 0.697F, 1.37F};
    constexpr Rgb pheomelanin = {0.187F, 0.4F, 1.05F};
    return melanin * (1 - redness) * eumelanin + melanin * redness * pheomelanin;
}

Rgb absorptionOfColor(Rgb color, double azimuthal) {
    const auto channel = [&](float c) {
        const double inside = (std::min(static_cast<double>(c), 0.99) - sheen) / (1 - sheen);
        const double root = std::log(std::max(inside, 1e-6)) / spreadOfColor(azimuthal);
        return static_cast<float>(root * root);
    };
    return {channel(color.r), channel(color.g), channel(color.b)};
}

Rgb colorOfAbsorption(Rgb absorption, double azimuthal) {
    const auto channel = [&](float sigma) {
        const double root = std::sqrt(static_cast<double>(sigma));
        return static_cast<float>(sheen + (1 - sheen) * std::exp(-spreadOfColor(azimuthal) * root));
    };
    return {channel(absorption.r), channel(absorption.g), channel(absorption.b)};
}

}  // namespace kushi
