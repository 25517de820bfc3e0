// SPDX-License-Identifier: Apache-2.0
#include "trace/sky.h"

#include <numbers>

namespace kushi {

Disc::Disc(const Light& light) : axes(normalized(light.direction)) {
    const double angle = std::clamp(static_cast<double>(light.halfAngle), 1e-3, radians(90));
    const double sine = std::sin(angle / 2);
    depth = static_cast<float>(2 * sine * sine);
    solidAngle = static_cast<float>(4 * std::numbers::pi * sine * sine);
    // The disc's cosines add up to pi sin^2; a white matt surface sends a pi-th of that.
    radiance = light.color * static_cast<float>(1 / (std::sin(angle) * std::sin(angle)));
}

Vec3f Disc::sample(Pair random) const {
    const float height = random.u * depth;  // 1 - cos
    const float sine = std::sqrt(height * (2 - height));
    const float turn = 2 * std::numbers::pi_v<float> * random.v;
    return axes.toWorld({sine * std::cos(turn), sine * std::sin(turn), 1 - height});
}

Sky::Sky(const Lights& lights) : dome(lights.ambient) {
    for (const Light& light : lights.distant) {
        if (!(brightest(light.color) > 0)) continue;
        const Disc& disc = discs.emplace_back(light);
        power += luminance(disc.solidAngle * disc.radiance);
    }
}

}  // namespace kushi
