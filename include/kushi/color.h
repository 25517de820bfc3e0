// SPDX-License-Identifier: Apache-2.0
#pragma once

namespace kushi {

/// Linear-light colour with the sRGB primaries; 1 is white, more is brighter.
struct Rgb {
    float r = 0, g = 0, b = 0;

    friend constexpr bool operator==(const Rgb&, const Rgb&) = default;
    friend constexpr Rgb operator+(Rgb p, Rgb q) { return {p.r + q.r, p.g + q.g, p.b + q.b}; }
    friend constexpr Rgb operator*(Rgb p, Rgb q) { return {p.r * q.r, p.g * q.g, p.b * q.b}; }
    friend constexpr Rgb operator*(Rgb p, float s) { return {p.r * s, p.g * s, p.b * s}; }
    friend constexpr Rgb operator*(float s, Rgb p) { return p * s; }
    constexpr Rgb& operator+=(Rgb other) { return *this = *this + other; }
};

/// `share` of the way from a to b.
constexpr Rgb mixed(Rgb a, Rgb b, double share) {
    const auto s = static_cast<float>(share);
    return a * (1 - s) + b * s;
}

}  // namespace kushi
