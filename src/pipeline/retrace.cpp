// SPDX-License-Identifier: Apache-2.0
#include "pipeline/retrace.h"

namespace kushi {

void retrace(std::span<const Vec3d> wanted, double scale, std::span<Vec3f> nodes) {
    Vec3d before = nodes[0].as<double>();
    Vec3d place = before;
    for (std::size_t j = 1; j < nodes.size(); ++j) {
        const Vec3d here = nodes[j].as<double>();
        const Vec3d way = here - before;
        const Vec3d aim = wanted[j] - wanted[j - 1];
        const double size = length(aim);
        place += (j > 1 ? scale : 1) * (size > 0 ? length(way) / size * aim : way);
        nodes[j] = place.as<float>();
        before = here;
    }
}

}  // namespace kushi
