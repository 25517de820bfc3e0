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

/// What hair that is packed too closely does to hair, in multiples of its weight: the gradient of a
/// head of pressure [m], which grows in each round where there is still too much.
class Pressure {
public:
    explicit Pressure(const Voxels& voxels) : voxels_(voxels), heads_(voxels.total()) {}

    /// packing  that hair may have, > 0
    void grow(const Density& density, float packing);

    /// On hair at a place.
    Vec3f pull(Vec3f place) const;

private:
    float head(int x, int y, int z) const;

    Voxels voxels_;
    std::vector<float> heads_;
};

}  // namespace kushi
