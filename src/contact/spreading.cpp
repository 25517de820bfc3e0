// SPDX-License-Identifier: Apache-2.0
#include "contact/spreading.h"

#include <algorithm>
#include <cstdint>

namespace kushi {

namespace {

constexpr int sweeps = 300;         // at most
constexpr float relaxation = 1.7F;  // of successive over-relaxation
constexpr float precision = 1e-3F;  // of the potential in a voxel, in squares of its size

Vec3f middleOf(const Voxels& voxels, int x, int y, int z) {
    const Vec3f corner = {static_cast<float>(x), static_cast<float>(y), static_cast<float>(z)};
    return voxels.origin + voxels.size * (corner + Vec3f{0.5F, 0.5F, 0.5F});
}

// The potential, in squares of a voxel's size, found by projected over-relaxation where hair is too
// close and as far around as it spreads.
class Sandpile {
public:
    Sandpile(const Density& density, float packing, const std::function<bool(Vec3f)>& inside)
        : voxels_(density.voxels()),
          excess_(voxels_.total()),
          potential_(voxels_.total()),
          kinds_(voxels_.total(), Kind::Border) {
        strides_ = {1, static_cast<std::size_t>(voxels_.count[0]),
                    gridIndex(voxels_.count, 0, 0, 1)};
        for (std::size_t i = 0; i < excess_.size(); ++i)
            excess_[i] = density.packing(i) / packing - 1;
        for (int z = 1; z + 1 < voxels_.count[2]; ++z)
            for (int y = 1; y + 1 < voxels_.count[1]; ++y)
                for (int x = 1; x + 1 < voxels_.count[0]; ++x)
                    kinds_[gridIndex(voxels_.count, x, y, z)] =
                        inside(middleOf(voxels_, x, y, z)) ? Kind::Wall : Kind::Free;
        for (std::size_t i = 0; i < excess_.size(); ++i)
            if (excess_[i] > 0) reach(i);
        for (int sweep = 0; sweep < sweeps; ++sweep)
            if (relax() < precision) break;
    }

    // How much it falls from the voxel before to the one behind, over both ways.
    Vec3f way(std::size_t i) const {
        if (kinds_[i] != Kind::Reached) return {};
        const auto fall = [&](std::size_t stride) {
            return 0.5F * (beside(i, i - stride) - beside(i, i + stride));
        };
        return voxels_.size * Vec3f{fall(strides_[0]), fall(strides_[1]), fall(strides_[2])};
    }

private:
    // The border takes all that comes there; hair has reached what has a potential, and what is
    // beside that; walls let nothing through.
    enum class Kind : std::uint8_t { Border, Free, Reached, Wall };

    void reach(std::size_t i) {
        if (kinds_[i] != Kind::Free) return;
        kinds_[i] = Kind::Reached;
        reached_.push_back(i);
    }

    float beside(std::size_t i, std::size_t other) const {
        return potential_[kinds_[other] == Kind::Wall ? i : other];
    }

    // Of all that are reached; returns the largest change.
    float relax() {
        float largest = 0;
        const std::size_t before = reached_.size();
        for (std::size_t k = 0; k < before; ++k) {
            const std::size_t i = reached_[k];
            float sum = excess_[i];
            float count = 0;
            for (const std::size_t stride : strides_)
                for (const std::size_t other : {i - stride, i + stride}) {
                    if (kinds_[other] == Kind::Wall) continue;
                    sum += potential_[other];
                    ++count;
                }
            if (count == 0) continue;
            const float old = potential_[i];
            potential_[i] = std::max(0.0F, old + relaxation * (sum / count - old));
            largest = std::max(largest, std::abs(potential_[i] - old));
            if (old > 0 || potential_[i] == 0) continue;
            for (const std::size_t stride : strides_) {
                reach(i - stride);
                reach(i + stride);
            }
        }
        return largest;
    }

    Voxels voxels_;
    std::array<std::size_t, 3> strides_{};
    std::vector<float> excess_;
    std::vector<float> potential_;
    std::vector<Kind> kinds_;
    std::vector<std::size_t> reached_;
};

}  // namespace

Spreading::Spreading(const Density& density, float packing,
                     const std::function<bool(Vec3f)>& inside)
    : voxels_(density.voxels()), spreads_(voxels_.total()) {
    const Sandpile sandpile(density, packing, inside);
    for (std::size_t i = 0; i < voxels_.total(); ++i)
        ways_.push_back(sandpile.way(i));
    for (std::size_t i = 0; i < voxels_.total(); ++i) {
        if (ways_[i] == Vec3f{}) continue;
        // None is at the border.
        const Corners all = {i - gridIndex(voxels_.count, 1, 1, 1), {}};
        forCorners(voxels_, all, [&](std::size_t lowest, float) { spreads_[lowest] = 1; });
    }
}

Vec3f Spreading::way(Vec3f place) const {
    const Corners corners = cornersAt(voxels_, place);
    Vec3f mean;
    if (spreads_[corners.first] == 0) return mean;
    forCorners(voxels_, corners,
               [&](std::size_t voxel, float share) { mean = mean + share * ways_[voxel]; });
    return mean;
}

}  // namespace kushi
