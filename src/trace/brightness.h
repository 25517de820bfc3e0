// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <kushi/color.h>

#include <algorithm>

namespace kushi {

/// As bright as it looks (Rec. 709).
constexpr float luminance(Rgb color) {
    return 0.2126F * color.r + 0.7152F * color.g + 0.0722F * color.b;
}

constexpr float brightest(Rgb color) {
    return std::max(color.r, std::max(color.g, color.b));
}

}  // namespace kushi
