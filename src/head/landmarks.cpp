// SPDX-License-Identifier: Apache-2.0
#include <kushi/head.h>

#include <algorithm>
#include <array>

namespace kushi {

namespace {

constexpr std::array<Landmark, 10> landmarks = {{{"crown", 0.1135},
                                                 {"hairline", 0.083},
                                                 {"brows", 0.022},
                                                 {"eyes", 0.002},
                                                 {"ears", -0.012},
                                                 {"nose", -0.033},
                                                 {"lips", -0.066},
                                                 {"nape", -0.066},
                                                 {"chin", -0.109},
                                                 {"shoulders", -0.193}}};

}  // namespace

Ellipsoid headEllipsoid() {
    return {.center = {}, .semiAxes = {0.105, 0.125, 0.085}, .rotateZ = radians(20)};
}

std::span<const Landmark> headLandmarks() {
    return landmarks;
}

std::optional<double> landmarkHeight(std::string_view name) {
    const auto* const found = std::ranges::find(landmarks, name, &Landmark::name);
    if (found == landmarks.end()) return std::nullopt;
    return found->y;
}

}  // namespace kushi
