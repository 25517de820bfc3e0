// SPDX-License-Identifier: Apache-2.0
#pragma once

namespace kushi {

/// Linear-light colour with the sRGB primaries; 1 is white, more is brighter.
struct Rgb {
    float r = 0, g = 0, b = 0;

    friend constexpr bool operator==(const Rgb&, const Rgb&) = default;
    friend constexpr Rgb operator+(Rgb a, Rgb b) { return {a.r + b.r, a.g + b.g, a.b + b.b}; }
    friend constexpr Rgb operator*(Rgb a, Rgb b) { return {a.r * b.r, a.g * b.g, a.b * b.b}; }
    friend constexpr Rgb operator*(Rgb a, float s) { return {a.r * s, a.g * s, a.b * s}; }
    friend constexpr Rgb operator*(float s, Rgb a) { return a * s; }
    constexpr Rgb& operator+=(Rgb other) { return *this = *this + other; }
};

}  // namespace kushi
