// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <kushi/mesh.h>

#include <array>
#include <cstdint>
#include <limits>
#include <string>
#include <vector>

namespace kushi {

/// The triangles of a mesh file as they stand there: in its units and axes, nothing joined.
struct Faces {
    static constexpr std::uint32_t none = std::numeric_limits<std::uint32_t>::max();

    struct Corner {
        std::uint32_t point = 0;      ///< index of points
        std::uint32_t normal = none;  ///< index of normals, or none
        std::uint32_t uv = none;      ///< index of uvs, or none
    };
    using Triangle = std::array<Corner, 3>;

    std::vector<Vec3d> points;   ///< finite
    std::vector<Vec3d> normals;  ///< of any length; one that is no direction counts as missing
    std::vector<TexturePoint> uvs;
    std::vector<Triangle> triangles;

    std::vector<std::uint16_t> groups;  ///< of each triangle: index of groupNames; or empty
    std::vector<std::vector<std::string>> groupNames;  ///< sorted, each once
};

}  // namespace kushi
