// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <algorithm>

namespace kushi {

/// 0 up to `low`, 1 from `high` on, and smooth between; low < high.
inline double smoothStep(double low, double high, double x) {
    const double t = std::clamp((x - low) / (high - low), 0.0, 1.0);
    return t * t * (3 - 2 * t);
}

}  // namespace kushi
