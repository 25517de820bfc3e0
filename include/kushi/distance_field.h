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

/// Where sample (x, y, z) of a grid lies in an array, x fastest, then y.
inline std::size_t gridIndex(const std::array<int, 3>& size, int x, int y, int z) {
    const auto row = static_cast<std::size_t>(z) * static_cast<std::size_t>(size[1]) +
                     static_cast<std::size_t>(y);
    return row * static_cast<std::size_t>(size[0]) + static_cast<std::size_t>(x);
}

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
    std::size_t index(int x, int y, int z) const { return gridIndex(size, x, y, z); }
};

struct DistanceFieldOptions {
    std::optional<double> spacing = {};  ///< m; left out: chosen from the solids' extent, see below
    int threads = 0;                     ///< 0: as many as the machine has
};

/// The distance field of solids. A mesh may be open, not manifold, cut itself and be wound either
/// way, piece by piece. Vertices at one place are one. Each piece (triangles that share edges with
/// one other triangle) is made to face one way, each of its openings closed by a fan around the
/// middle of its border, and the piece turned outwards. Then a place is inside where the surface
/// winds around it (winding number; Jacobson, Kavan and Sorkine 2013), and how deep it is there is
/// the distance to those triangles that have an outside.
///
/// The grid holds the solids with their offsets and 2 cm around them. Its spacing is 2.5 mm where
/// that takes 24 million samples at most, else what takes so many. Distances are those to the
/// triangles, rounded to a unit, within 2 cm of them (and of the offset surface), and within half
/// a spacing farther off. The same bytes from any number of threads.
///
/// No solids, or none with a triangle: an empty field. A problem is: more than 255 solids; a
/// spacing that is not positive, or takes more than 256 million samples; an offset or a vertex that
/// is not finite or beyond 1 km; a triangle with a vertex that the mesh does not have.
Result<DistanceField> distanceFieldOf(std::span<const Solid> solids,
                                      const DistanceFieldOptions& options = {});

/// Distance at a place, linear between samples [m]. Outside of the grid, that of the nearest place
/// in it and the way there. An empty field is 1 m from anywhere. Not a number where the place is.
float distanceAt(const DistanceField& field, Vec3f place);

}  // namespace kushi
