// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <kushi/distance_field.h>
#include <kushi/vec.h>

#include <array>
#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

namespace kushi {

/// A box of cubes.
struct Voxels {
    Vec3f origin;         ///< corner of the first [m]
    float size = 0.005F;  ///< of a cube's edge [m]
    std::array<int, 3> count{};

    std::size_t total() const { return gridIndex(count, 0, 0, count[2]); }
};

/// Voxels that hold all of some places and two more around them.
Voxels voxelsAround(std::span<const Vec3f> places, float size);

/// The eight voxels of which the middles are around a place.
struct Corners {
    std::size_t first;             ///< the lowest
    std::array<float, 3> farther;  ///< shares of the way from its middle to the next ones
};

/// Beyond the outermost middles, as at them.
Corners cornersAt(const Voxels& voxels, Vec3f place);

/// How much of a place each of the corners has: take(std::size_t voxel, float share).
template <class Take>
void forCorners(const Voxels& voxels, const Corners& corners, const Take& take) {
    const float x = corners.farther[0];
    const float y = corners.farther[1];
    const float z = corners.farther[2];
    const auto pair = [&](std::size_t voxel, float share) {
        take(voxel, (1 - x) * share);
        take(voxel + 1, x * share);
    };
    const std::size_t row = gridIndex(voxels.count, 0, 1, 0);
    const std::size_t slice = gridIndex(voxels.count, 0, 0, 1);
    pair(corners.first, (1 - y) * (1 - z));
    pair(corners.first + row, y * (1 - z));
    pair(corners.first + slice, (1 - y) * z);
    pair(corners.first + row + slice, y * z);
}

/// How much of each voxel is hair, in whole numbers, so that it does not matter in which order
/// hairs are added or put together.
class Density {
public:
    explicit Density(const Voxels& voxels) : voxels_(voxels), volumes_(voxels.total()) {}

    /// A strand's volume, spread linearly over the voxels around the middles of short pieces.
    ///
    /// section  of the hair [m2]
    void add(std::span<const Vec3f> nodes, double section);
    void add(const Density& other);

    const Voxels& voxels() const { return voxels_; }
    /// Of a voxel, by its place in x, then y, then z.
    float packing(std::size_t voxel) const;
    float largestPacking() const;
    /// Of the voxels that hold at least so much [m3].
    double volume(float least) const;

private:
    Voxels voxels_;
    std::vector<std::uint64_t> volumes_;
};

}  // namespace kushi
