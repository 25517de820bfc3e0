// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <kushi/vec.h>

#include <array>
#include <cstdint>
#include <limits>
#include <vector>

namespace kushi {

/// The triangles of a mesh file as they stand there: in its units and axes, nothing joined.
struct Faces {
    static constexpr std::uint32_t noNormal = std::numeric_limits<std::uint32_t>::max();

    struct Corner {
        std::uint32_t point = 0;          ///< index of points
        std::uint32_t normal = noNormal;  ///< index of normals, or noNormal
    };
    using Triangle = std::array<Corner, 3>;

    std::vector<Vec3d> points;   ///< finite
    std::vector<Vec3d> normals;  ///< of any length; one that is no direction counts as missing
    std::vector<Triangle> triangles;
};

}  // namespace kushi
