// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <kushi/distance_field.h>
#include <kushi/strands.h>

#include <array>
#include <cstddef>
#include <vector>

namespace kushi {

/// Cubes over all of the hair: how much of it there is in each, and which way it runs.
struct HairGrid {
    /// What a ray meets in a cube.
    struct Cell {
        Vec3f way;          ///< mean direction root to tip; its length is how much the hair agrees
        float density = 0;  ///< fibre length times diameter per volume [1/m]

        /// Fibres that a ray along the unit `direction` crosses per metre. Where hair runs all
        /// ways it counts as at the mean angle to the ray.
        float crossings(Vec3f direction) const;
    };

    Vec3f low;                       ///< m, corner of the first cube
    float size = 1;                  ///< m, of a cube's edges
    std::array<int, 3> counts = {};  ///< cubes along x, y, z
    std::vector<Cell> cells;         ///< x fastest, then y

    std::size_t index(int x, int y, int z) const { return gridIndex(counts, x, y, z); }
    /// From a cube to the next along x, y, z.
    std::array<std::size_t, 3> strides() const {
        return {index(1, 0, 0), index(0, 1, 0), index(0, 0, 1)};
    }
    Vec3f middle(std::size_t cell) const;
    /// The cube in which a place lies, or the one nearest to it.
    std::size_t cubeAt(Vec3f place) const;
    bool empty() const { return cells.empty(); }
};

/// Sums up the segments, each in pieces shorter than a cube. Whole numbers are added, so the order
/// does not matter: the same grid from any number of threads.
///
/// strands  without diameters they are 75 micrometres thick
/// cells    cubes along the longest side of the hair's bounds, about; none is smaller than 3 mm
HairGrid hairGrid(const Strands& strands, int cells, int threads);

/// The eight cubes between whose centres a place lies, by x, then y, then z. Beyond the centres of
/// the outermost cubes their values go on.
struct GridPlace {
    std::array<std::size_t, 8> cubes;
    std::array<float, 8> weights;  ///< 1 in all
};

GridPlace placeIn(const HairGrid& grid, Vec3f place);

}  // namespace kushi
