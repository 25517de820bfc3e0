// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <kushi/mesh.h>
#include <kushi/result.h>

#include <array>
#include <cstddef>
#include <cstdint>
#include <optional>
#include <span>
#include <vector>

namespace kushi {

/// What hair must stay out of: a closed or open surface, and how far off it hair is kept.
struct Solid {
    Mesh mesh;
    double offset = 0;  ///< the solid is taken to be so much larger [m]; negative: smaller
};

/// Signed distance to the union of solids on a grid of samples, below zero inside.
struct DistanceField {
    Vec3f origin;                       ///< place of the first sample [m]
    float spacing = 0;                  ///< between samples [m]; 0: an empty field
    std::array<int, 3> size{};          ///< samples along x, y and z
    std::vector<std::int16_t> units;    ///< x fastest, then y; distance / unit(), saturated
    std::vector<std::uint8_t> nearest;  ///< which solid is nearest to each sample; empty: the first

    static constexpr float unitsPerSpacing = 256;
    float unit() const { return spacing / unitsPerSpacing; }
    bool empty() const { return units.empty(); }
    std::size_t index(int x, int y, int z) const {
        const auto row = static_cast<std::size_t>(z) * static_cast<std::size_t>(size[1]) +
                         static_cast<std::size_t>(y);
        return row * static_cast<std::size_t>(size[0]) + static_cast<std::size_t>(x);
    }
};

struct DistanceFieldOptions {
    std::optional<double> spacing;  ///< m; left out: chosen from the solids' extent, see below
    int threads = 0;                ///< 0: as many as the machine has
};

/// The distance field of solids. A mesh may be open, not manifold, cut itself and be wound either
/// way, piece by piece: a place is inside where the surface winds around it by more than half
/// (generalized winding number; Jacobson, Kavan and Sorkine 2013), with each connected piece turned
/// outwards first. An opening is closed by the surface on which it winds by a half.
///
/// The grid holds the solids with their offsets and 2 cm around them. Its spacing is 2.5 mm where
/// that takes 24 million samples at most, else what takes so many. Distances are those to the
/// triangles, up to the accuracy of a sample, within 2 cm of a surface, and within half a spacing
/// farther off. The same bytes from any number of threads.
///
/// No solids, or none with a triangle: an empty field. More than 255 solids, a spacing that is not
/// positive, or a vertex that is not finite is a problem.
Result<DistanceField> distanceFieldOf(std::span<const Solid> solids,
                                      const DistanceFieldOptions& options = {});

/// Distance at a place, linear between samples [m]. Outside of the grid, that of the nearest place
/// in it and the way there. An empty field is 1 m from anywhere.
float distanceAt(const DistanceField& field, Vec3f place);

}  // namespace kushi
