// SPDX-License-Identifier: Apache-2.0
#include "trace/pixel_filter.h"

#include <cmath>
#include <numbers>

namespace kushi {

namespace {

constexpr double width = 3;  // pixels

/// The share of the window before t of its width.
double before(double t) {
    const double angle = 2 * std::numbers::pi * t;
    const double waves = -0.48829 * std::sin(angle) + 0.14128 / 2 * std::sin(2 * angle) -
                         0.01168 / 3 * std::sin(3 * angle);
    return t + waves / (0.35875 * 2 * std::numbers::pi);
}

/// The t in [0, 1] before which that share lies.
double placeOf(double share) {
    double low = 0;
    double high = 1;
    for (int i = 0; i < 40; ++i) {
        const double middle = (low + high) / 2;
        (before(middle) < share ? low : high) = middle;
    }
    return (low + high) / 2;
}

}  // namespace

PixelFilter::PixelFilter() {
    for (std::size_t i = 0; i <= steps; ++i)
        at_[i] = static_cast<float>(width * (placeOf(static_cast<double>(i) / steps) - 0.5));
}

}  // namespace kushi
