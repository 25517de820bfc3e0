// SPDX-License-Identifier: Apache-2.0
#include "pipeline/patch.h"

#include "core/random.h"

#include <cmath>

namespace kushi {

std::uint64_t patchOf(Vec3d root, double size, std::uint64_t salt) {
    const Vec3d scaled = root / size;
    double nearest = 1e30;
    std::uint64_t patch = 0;
    const auto beside = [](double place, int step) { return std::floor(place) + step - 1; };
    for (int i = 0; i < 27; ++i) {
        const int layer = i / 9;
        const int row = i / 3 % 3;
        const Vec3d cell = {beside(scaled.x, i % 3), beside(scaled.y, row),
                            beside(scaled.z, layer)};
        std::uint64_t key = salt;
        for (const double number : {cell.x, cell.y, cell.z})
            key = mixKey(key, static_cast<std::uint64_t>(static_cast<std::int64_t>(number)));
        const Vec3d point =
            cell + Vec3d{uniform(mixKey(key, 1)), uniform(mixKey(key, 2)), uniform(mixKey(key, 3))};
        const double distance = length(point - scaled);
        if (distance < nearest) {
            nearest = distance;
            patch = key;
        }
    }
    return patch;
}

}  // namespace kushi
