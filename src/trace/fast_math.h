// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <algorithm>
#include <bit>
#include <cmath>
#include <cstdint>
#include <numbers>

namespace kushi {

// Without branches, so that compilers make lanes of loops over them.

/// The whole number nearest to |x| < 2^22.
inline float nearest(float x) {
    constexpr float shifter = 0x1.8p23F;
    return (x + shifter) - shifter;
}

/// exp(x) to 4e-6 of itself for x in [-87, 0]; exp(-87) below.
inline float fastExp(float x) {
    constexpr float shifter = 0x1.8p23F;
    const float y = std::max(x, -87.0F) * std::numbers::log2e_v<float>;
    const float shifted = y + shifter;  // has the nearest whole number in its last bits
    const float r = (y - (shifted - shifter)) * std::numbers::ln2_v<float>;
    const float e =
        1 + r * (1 + r * (1.0F / 2 + r * (1.0F / 6 + r * (1.0F / 24 + r * (1.0F / 120)))));
    return e * std::bit_cast<float>((std::bit_cast<std::uint32_t>(shifted) + 127U) << 23U);
}

/// asin(x) to 7e-5 (Abramowitz and Stegun 4.4.45).
inline float fastAsin(float x) {
    const float a = std::abs(x);
    const float p = 1.5707288F + a * (-0.2121144F + a * (0.0742610F + a * -0.0187293F));
    const float value = std::numbers::pi_v<float> / 2 - std::sqrt(std::max(0.0F, 1 - a)) * p;
    return std::copysign(value, x);
}

}  // namespace kushi
