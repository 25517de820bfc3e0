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

// How fast pressure grows: a voxel that holds twice of what it may raises the head of pressure by
// so many voxels in a round. More makes new piles where hair goes.
constexpr float gain = 0.4F;

// Of a place among voxels' middles: the one before and the share of the way to the next.
struct Cell {
    int first;
    float share;
};

Cell cellAt(float place, float origin, float size, int count) {
    const float at = (place - origin) / size - 0.5F;
    // In this order, what is no number becomes 0.
    const float held = std::min(std::max(0.0F, at), static_cast<float>(count - 1));
    const int first = std::min(static_cast<int>(held), count - 2);
    return {first, held - static_cast<float>(first)};
}

std::array<Cell, 3> cellsAt(const Voxels& voxels, Vec3f place) {
    return {cellAt(place.x, voxels.origin.x, voxels.size, voxels.count[0]),
            cellAt(place.y, voxels.origin.y, voxels.size, voxels.count[1]),
            cellAt(place.z, voxels.origin.z, voxels.size, voxels.count[2])};
}

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
            const auto [x, y, z] = cellsAt(voxels_, nodes[j - 1] + share * way);
            for (int corner = 0; corner < 8; ++corner) {
                const int dx = corner & 1;
                const int dy = corner >> 1 & 1;
                const int dz = corner >> 2;
                const float weight = (dx == 0 ? 1 - x.share : x.share) *
                                     (dy == 0 ? 1 - y.share : y.share) *
                                     (dz == 0 ? 1 - z.share : z.share);
                volumes_[gridIndex(voxels_.count, x.first + dx, y.first + dy, z.first + dz)] +=
                    static_cast<std::uint64_t>(weight * piece);
            }
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

namespace {

// Each voxel's mean with those beside it, along one axis.
void blur(std::size_t stride, int along, std::vector<float>& values) {
    std::vector<float> line;
    const auto length = static_cast<std::size_t>(along);
    for (std::size_t first = 0; first < values.size(); ++first) {
        if (first / stride % length != 0) continue;
        line.clear();
        for (std::size_t i = 0; i < length; ++i)
            line.push_back(values[first + i * stride]);
        for (std::size_t i = 1; i + 1 < length; ++i)
            values[first + i * stride] = 0.25F * line[i - 1] + 0.5F * line[i] + 0.25F * line[i + 1];
    }
}

}  // namespace

void Pressure::grow(const Density& density, float packing) {
    std::vector<float> change(heads_.size());
    for (std::size_t i = 0; i < heads_.size(); ++i) {
        const float excess = density.packing(i) / packing - 1;
        // What has become free gives way more slowly, or hair would fall back at once.
        change[i] = excess > 0 ? std::min(excess, 2.0F) : (heads_[i] > 0 ? 0.25F * excess : 0);
    }
    const auto x = static_cast<std::size_t>(voxels_.count[0]);
    const auto y = static_cast<std::size_t>(voxels_.count[1]);
    blur(1, voxels_.count[0], change);
    blur(x, voxels_.count[1], change);
    blur(x * y, voxels_.count[2], change);
    for (std::size_t i = 0; i < heads_.size(); ++i)
        heads_[i] = std::max(0.0F, heads_[i] + gain * voxels_.size * change[i]);
}

float Pressure::head(int x, int y, int z) const {
    return heads_[gridIndex(voxels_.count, x, y, z)];
}

Vec3f Pressure::pull(Vec3f place) const {
    const auto [x, y, z] = cellsAt(voxels_, place);
    const auto at = [&, cx = x, cy = y, cz = z](int dx, int dy, int dz) {
        return head(cx.first + dx, cy.first + dy, cz.first + dz);
    };
    const auto mix = [](float a, float b, float share) { return a + share * (b - a); };
    const auto slope = [&](const auto& difference, float first, float second) {
        return mix(mix(difference(0, 0), difference(1, 0), first),
                   mix(difference(0, 1), difference(1, 1), first), second) /
               -voxels_.size;
    };
    return {slope([&](int j, int k) { return at(1, j, k) - at(0, j, k); }, y.share, z.share),
            slope([&](int i, int k) { return at(i, 1, k) - at(i, 0, k); }, x.share, z.share),
            slope([&](int i, int j) { return at(i, j, 1) - at(i, j, 0); }, x.share, y.share)};
}

}  // namespace kushi
