// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cmath>
#include <numbers>

namespace kushi {

/// exp(-x) I0(x) for x >= 0, to the last few bits: the power series, of which no term is negative,
/// and for large x Hankel's expansion.
inline double besselI0Scaled(double x) {
    double term = 1;
    double sum = 1;
    if (x < 30) {
        for (int k = 1; term > 1e-17 * sum; ++k) {
            term *= x * x / (4.0 * k * k);
            sum += term;
        }
        return std::exp(-x) * sum;
    }
    for (int k = 1; k < 30 && term > 1e-17; ++k) {
        term *= (2 * k - 1) * (2 * k - 1) / (8 * k * x);
        sum += term;
    }
    return sum / std::sqrt(2 * std::numbers::pi * x);
}

/// The same to 4e-7 (Abramowitz and Stegun 9.8.1 and 9.8.2).
inline float besselI0Scaled(float x) {
    if (x < 3.75F) {
        const float t = x * x / (3.75F * 3.75F);
        const float i0 =
            1 + t * (3.5156229F +
                     t * (3.0899424F +
                          t * (1.2067492F + t * (0.2659732F + t * (0.0360768F + t * 0.0045813F)))));
        return std::exp(-x) * i0;
    }
    const float t = 3.75F / x;
    const float low = 0.39894228F + t * (0.01328592F + t * (0.00225319F + t * -0.00157565F));
    const float high =
        0.00916281F + t * (-0.02057706F + t * (0.02635537F + t * (-0.01647633F + t * 0.00392377F)));
    const float t2 = t * t;
    return (low + t2 * t2 * high) / std::sqrt(x);
}

}  // namespace kushi
