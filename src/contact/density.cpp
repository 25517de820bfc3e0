// SPDX-License-Identifier: Apache-2.0
//
// After Petrovic, Henne and Anderson, "Volumetric Methods for Simulation and Rendering of Hair",
// Pixar Technical Memo 06-08, 2005: hair pushes hair by the density of all.
#include "contact/density.h"

#include <algorithm>
#include <cmath>

namespace kushi {

namespace {

// Of a voxel's volume: what a count of one stands for. A whole voxel of hair is 2^40.
constexpr double counts = 1099511627776.0;

}  // namespace

Voxels voxelsAround(std::span<const Vec3f> places, float size) {
    Vec3f low = places.empty() ? Vec3f{} : places[0];
    Vec3f high = low;
    for (const Vec3f p : places) {
        low = {std::min(low.x, p.x), std::min(low.y, p.y), std::min(low.z, p.z)};
        high = {std::max(high.x, p.x), std::max(high.y, p.y), std::max(high.z, p.z)};
    }
    Voxels voxels;
    voxels.size = size;
    voxels.origin = low - Vec3f{2 * size, 2 * size, 2 * size};
    const Vec3f extent = high - low;
    const float sizes[] = {extent.x, extent.y, extent.z};
    for (std::size_t axis = 0; axis < 3; ++axis)
        voxels.count[axis] = static_cast<int>(std::ceil(sizes[axis] / size)) + 4;
    return voxels;
}

Corners cornersAt(const Voxels& voxels, Vec3f place) {
    const float at[] = {place.x - voxels.origin.x, place.y - voxels.origin.y,
                        place.z - voxels.origin.z};
    std::array<int, 3> first{};
    Corners corners{};
    for (std::size_t axis = 0; axis < 3; ++axis) {
        // In this order, what is no number becomes 0.
        const float held = std::min(std::max(0.0F, at[axis] / voxels.size - 0.5F),
                                    static_cast<float>(voxels.count[axis] - 1));
        first[axis] = std::min(static_cast<int>(held), voxels.count[axis] - 2);
        corners.farther[axis] = held - static_cast<float>(first[axis]);
    }
    corners.first = gridIndex(voxels.count, first[0], first[1], first[2]);
    return corners;
}

void Density::add(std::span<const Vec3f> nodes, double section) {
    const double scale =
        counts * section / (double{voxels_.size} * double{voxels_.size} * double{voxels_.size});
    for (std::size_t j = 1; j < nodes.size(); ++j) {
        const Vec3f way = nodes[j] - nodes[j - 1];
        const float size = length(way);
        const int pieces = std::max(1, static_cast<int>(std::ceil(2 * size / voxels_.size)));
        const auto piece = static_cast<float>(scale * double{size} / pieces);
        for (int k = 0; k < pieces; ++k) {
            const float share = (static_cast<float>(k) + 0.5F) / static_cast<float>(pieces);
            const Corners corners = cornersAt(voxels_, nodes[j - 1] + share * way);
            forCorners(voxels_, corners, [&](std::size_t voxel, float part) {
                volumes_[voxel] +=
                    static_cast<std::uint64_t>(static_cast<std::int64_t>(part * piece));
            });
        }
    }
}

void Density::add(const Density& other) {
    for (std::size_t i = 0; i < volumes_.size(); ++i)
        volumes_[i] += other.volumes_[i];
}

float Density::packing(std::size_t voxel) const {
    return static_cast<float>(static_cast<double>(volumes_[voxel]) / counts);
}

float Density::largestPacking() const {
    const auto most = std::ranges::max_element(volumes_);
    return most == volumes_.end() ? 0 : packing(static_cast<std::size_t>(most - volumes_.begin()));
}

double Density::volume(float least) const {
    std::size_t some = 0;
    for (std::size_t i = 0; i < volumes_.size(); ++i)
        some += packing(i) >= least ? 1 : 0;
    return static_cast<double>(some) * std::pow(double{voxels_.size}, 3);
}

}  // namespace kushi
