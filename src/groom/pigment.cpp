// SPDX-License-Identifier: Apache-2.0
#include <kushi/pigment.h>

#include <algorithm>
#include <cmath>

namespace kushi {

namespace {

/// The denominator of Chiang's fit.
double spreadOfColor(double b) {
    return 5.969 + b * (-0.215 + b * (2.532 + b * (-10.73 + b * (5.574 + b * 0.245))));
}

}  // namespace

Rgb absorptionOfMelanin(float melanin, float redness) {
    constexpr Rgb eumelanin = {0.419F, 0.697F, 1.37F};
    constexpr Rgb pheomelanin = {0.187F, 0.4F, 1.05F};
    return melanin * (1 - redness) * eumelanin + melanin * redness * pheomelanin;
}

Rgb absorptionOfColor(Rgb color, double azimuthal) {
    const auto channel = [&](float c) {
        const double root =
            std::log(std::clamp(static_cast<double>(c), 1e-6, 0.99)) / spreadOfColor(azimuthal);
        return static_cast<float>(root * root);
    };
    return {channel(color.r), channel(color.g), channel(color.b)};
}

Rgb colorOfAbsorption(Rgb absorption, double azimuthal) {
    const auto channel = [&](float sigma) {
        return static_cast<float>(
            std::exp(-spreadOfColor(azimuthal) * std::sqrt(static_cast<double>(sigma))));
    };
    return {channel(absorption.r), channel(absorption.g), channel(absorption.b)};
}

}  // namespace kushi
