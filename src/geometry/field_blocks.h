// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "geometry/probe.h"

#include <kushi/distance_field.h>

#include <array>
#include <vector>

namespace kushi {

/// A closed surface, and its skin where that is less; otherwise the skin is empty. The surface
/// tells sides and is what is nearest to places outside, the skin to those inside.
struct SolidTrees {
    TriangleTree surface;
    TriangleTree skin;

    const TriangleTree& from(bool inside) const {
        return inside && !skin.nodes.empty() ? skin : surface;
    }
};

/// The samples of a field in blocks of 4 x 4 x 4 (fewer at the far ends), each with what is
/// nearest to its middle.
struct FieldBlocks {
    static constexpr int side = 4;

    std::array<int, 3> size{};
    std::vector<Probe> middles;
    std::vector<Nearest> nearest;

    std::size_t index(int x, int y, int z) const { return gridIndex(size, x, y, z); }
};

FieldBlocks blocksOf(const DistanceField& grid, const SolidTrees& trees, int threads);

/// The points that are nearest to the middles of a block and of those around it.
std::vector<Vec3f> pointsAround(const FieldBlocks& blocks, int x, int y, int z);

}  // namespace kushi
