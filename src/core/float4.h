// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <bit>
#include <cmath>
#include <cstdint>

namespace kushi {

/// Four floats at once, in a register of every x86-64 and arm64; the same results on all of them.
using Float4 = float __attribute__((vector_size(16)));
using Int4 = std::int32_t __attribute__((vector_size(16)));

inline Float4 float4(float x) {
    return Float4{x, x, x, x};
}

inline Float4 smaller(Float4 a, Float4 b) {
    return a < b ? a : b;
}
inline Float4 larger(Float4 a, Float4 b) {
    return a > b ? a : b;
}

inline Float4 squareRoot(Float4 x) {
    return Float4{std::sqrt(x[0]), std::sqrt(x[1]), std::sqrt(x[2]), std::sqrt(x[3])};
}

/// Towards 0; in the range of Int4.
inline Int4 truncated(Float4 a) {
    return __builtin_convertvector(a, Int4);
}

/// exp(x) to 3e-7 for x in [-80, 80]; beyond it is that of the nearest end.
inline Float4 exponential(Float4 x) {
    x = smaller(larger(x, float4(-80)), float4(80));
    // 2^(n + f), n rounded by the loss of what lies behind the point.
    constexpr float shift = 0x1.8p23F;
    const Float4 scaled = x * 1.44269504F;
    const Float4 shifted = scaled + shift;
    const Float4 whole = shifted - shift;
    const Float4 f = (x - whole * 0.693359375F) + whole * 2.12194440e-4F;
    // Taylor's, over [-ln 2 / 2, ln 2 / 2].
    Float4 power = float4(1.0F / 720);
    power = power * f + 1.0F / 120;
    power = power * f + 1.0F / 24;
    power = power * f + 1.0F / 6;
    power = power * f + 0.5F;
    power = power * f + 1;
    power = power * f + 1;
    const Int4 exponent = truncated(whole) << 23;
    return std::bit_cast<Float4>(std::bit_cast<Int4>(power) + exponent);
}

/// The angle in [0, pi] to 7e-5 rad (Abramowitz and Stegun 4.4.45); x in [-1, 1].
inline Float4 arcCosine(Float4 x) {
    const Float4 size = x < 0 ? -x : x;
    const Float4 angle =
        squareRoot(larger(1 - size, float4(0))) *
        (1.5707288F + size * (-0.2121144F + size * (0.0742610F + size * -0.0187293F)));
    return x < 0 ? 3.14159265F - angle : angle;
}

}  // namespace kushi
