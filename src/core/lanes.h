// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <bit>
#include <cmath>
#include <cstdint>

namespace kushi {

/// Four floats at once, in a register of every x86-64 and arm64; the same results on all of them.
using Lanes = float __attribute__((vector_size(16)));

inline Lanes lanes(float x) {
    return Lanes{x, x, x, x};
}

inline Lanes least(Lanes a, Lanes b) {
    return a < b ? a : b;
}
inline Lanes most(Lanes a, Lanes b) {
    return a > b ? a : b;
}

inline Lanes squareRoot(Lanes x) {
    return Lanes{std::sqrt(x[0]), std::sqrt(x[1]), std::sqrt(x[2]), std::sqrt(x[3])};
}

/// exp(x) to 3e-7 for x in [-80, 80]; beyond it is that of the nearest end.
inline Lanes exponential(Lanes x) {
    using Whole = std::int32_t __attribute__((vector_size(16)));
    x = least(most(x, lanes(-80)), lanes(80));
    // 2^(n + f), n rounded by the loss of what lies behind the point.
    constexpr float shift = 0x1.8p23F;
    const Lanes scaled = x * 1.44269504F;
    const Lanes shifted = scaled + shift;
    const Lanes whole = shifted - shift;
    const Lanes f = (x - whole * 0.693359375F) + whole * 2.12194440e-4F;
    // Taylor's, over [-ln 2 / 2, ln 2 / 2].
    Lanes power = lanes(1.0F / 720);
    power = power * f + 1.0F / 120;
    power = power * f + 1.0F / 24;
    power = power * f + 1.0F / 6;
    power = power * f + 0.5F;
    power = power * f + 1;
    power = power * f + 1;
    const Whole exponent = __builtin_convertvector(whole, Whole) << 23;
    return std::bit_cast<Lanes>(std::bit_cast<Whole>(power) + exponent);
}

/// The angle in [0, pi] to 7e-5 rad (Abramowitz and Stegun 4.4.45); x in [-1, 1].
inline Lanes arcCosine(Lanes x) {
    const Lanes size = x < 0 ? -x : x;
    const Lanes angle = squareRoot(most(1 - size, lanes(0))) *
                        (1.5707288F + size * (-0.2121144F + size * (0.0742610F + size * -0.0187293F)));
    return x < 0 ? 3.14159265F - angle : angle;
}

}  // namespace kushi
