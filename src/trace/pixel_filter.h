// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <algorithm>
#include <array>
#include <cstddef>

namespace kushi {

/// How a pixel weighs what lies around its middle: along x and y alike the window of Blackman and
/// Harris (1978, four terms), three pixels wide. Samples are placed with its density, so that all
/// count the same and pixels stay independent (Ernst, Stamminger and Greiner 2006).
class PixelFilter {
public:
    PixelFilter();

    /// Pixels off the middle, in [-1.5, 1.5], for a number in [0, 1].
    float place(float random) const {
        const float x = random * steps;
        const std::size_t i = std::min(static_cast<std::size_t>(x), steps - 1);
        return at_[i] + (x - static_cast<float>(i)) * (at_[i + 1] - at_[i]);
    }

private:
    static constexpr std::size_t steps = 1024;
    std::array<float, steps + 1> at_{};
};

}  // namespace kushi
