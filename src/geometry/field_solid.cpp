// SPDX-License-Identifier: Apache-2.0
#include "geometry/field_solid.h"

#include "core/parallel.h"
#include "geometry/closed_surface.h"
#include "geometry/field_blocks.h"
#include "geometry/four_distances.h"
#include "geometry/skin.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace kushi {
namespace {

constexpr int side = FieldBlocks::side;

/// How far from a solid distances are exact, at least [m]: 2 cm, and something for rounding.
constexpr float exactReach = 0.0201F;
/// And at least so many spacings: from there on the points nearest to the blocks around are as good
/// as exact, within 0.3 of a spacing.
constexpr float exactSpacings = 8;

Four distancesTo(const std::vector<Vec3f>& points, const FourPlaces& places) {
    Four least = Four{} + std::numeric_limits<float>::max();
    for (const Vec3f point : points) {
        const Four x = places.x - point.x, y = places.y - point.y, z = places.z - point.z;
        const Four square = x * x + y * y + z * z;
        least = square < least ? square : least;
    }
    return roots(least);
}

float leastOf(Four a) {
    return std::min(std::min(a[0], a[1]), std::min(a[2], a[3]));
}

/// `i`, or as far from the other end.
int turned(int i, bool back) {
    return back ? side - 1 - i : i;
}

class SolidSampler {
public:
    SolidSampler(DistanceField& field, const SolidTrees& trees, const FieldBlocks& blocks,
                 float offset, std::uint8_t solid)
        : field_(field),
          trees_(trees),
          blocks_(blocks),
          offset_(offset),
          solid_(solid),
          reach_(std::max(exactReach, exactSpacings * field.spacing) + std::abs(offset)) {}

    void sampleBlock(int blockX, int blockY, int blockZ) {
        const std::size_t block = blocks_.index(blockX, blockY, blockZ);
        const Probe& middle = blocks_.middles[block];
        const std::vector<Vec3f> around = pointsAround(blocks_, blockX, blockY, blockZ);
        const float radius = 0.5F * std::sqrt(3.0F) * (side - 1) * field_.spacing;
        const float blockAtLeast = middle.distance - radius;
        float atLeast = blockAtLeast;
        // The sample before, too: samples follow each other without a jump.
        std::array<Probe, 2> nearby = {middle, middle};
        std::uint32_t guess = blocks_.nearest[block].triangle, skinGuess = 0;
        const int x = side * blockX;
        for (int row = 0; row < side * side; ++row) {
            const int z = row / side;
            const int y = turned(row % side, z % 2 == 1);
            const FourPlaces places = fourPlaces(x, side * blockY + y, side * blockZ + z);
            const bool far = atLeast > reach_;
            const Four distances =
                far ? distancesTo(around, places) : fourDistances(trees_.surface, places, guess);
            const Four depths = far || trees_.skin.nodes.empty()
                                    ? distances
                                    : fourDistances(trees_.skin, places, skinGuess);
            atLeast = std::max(blockAtLeast, (far ? atLeast : leastOf(distances)) - field_.spacing);
            for (int n = 0; n < side; ++n) {
                const int i = turned(n, row % 2 == 1);
                const Vec3f place = {places.x[i], places.y[i], places.z[i]};
                nearby[1] = probeOf(trees_.surface, place, distances[i], nearby);
                const bool inside = nearby[1].inside;
                store(x + i, side * blockY + y, side * blockZ + z,
                      inside ? depths[i] : distances[i], inside);
            }
        }
    }

private:
    FourPlaces fourPlaces(int x, int y, int z) const {
        const Four steps = {0, 1, 2, 3};
        return {field_.origin.x + field_.spacing * (steps + static_cast<float>(x)),
                Four{} + (field_.origin.y + field_.spacing * static_cast<float>(y)),
                Four{} + (field_.origin.z + field_.spacing * static_cast<float>(z))};
    }

    /// Blocks may stick out of the field.
    void store(int x, int y, int z, float distance, bool inside) {
        if (x >= field_.size[0] || y >= field_.size[1] || z >= field_.size[2]) return;
        const std::size_t sample = field_.index(x, y, z);
        constexpr float most = std::numeric_limits<std::int16_t>::max();
        const float units = ((inside ? -distance : distance) - offset_) / field_.unit();
        const auto rounded = static_cast<std::int16_t>(std::lround(std::clamp(units, -most, most)));
        if (rounded >= field_.units[sample]) return;
        field_.units[sample] = rounded;
        if (!field_.nearest.empty()) field_.nearest[sample] = solid_;
    }

    DistanceField& field_;
    const SolidTrees& trees_;
    const FieldBlocks& blocks_;
    float offset_;
    std::uint8_t solid_;
    float reach_;
};

}  // namespace

void addSolid(DistanceField& field, const Solid& solid, std::uint8_t index, int threads) {
    SolidTrees trees = {treeOf(closedSurface(solid.mesh)), {}};
    if (trees.surface.nodes.empty()) return;
    std::vector<Triangle> skin = skinOf(trees.surface, threads);
    if (skin.size() < trees.surface.triangles.size()) trees.skin = treeOf(std::move(skin));
    const FieldBlocks blocks = blocksOf(field, trees, threads);
    SolidSampler sampler(field, trees, blocks, static_cast<float>(solid.offset), index);
    parallelFor(blocks.middles.size(), 16, threads, [&](std::size_t begin, std::size_t end) {
        const auto columns = static_cast<std::size_t>(blocks.size[0]);
        const auto rows = static_cast<std::size_t>(blocks.size[1]);
        for (std::size_t i = begin; i < end; ++i) {
            sampler.sampleBlock(static_cast<int>(i % columns), static_cast<int>(i / columns % rows),
                                static_cast<int>(i / columns / rows));
        }
    });
}

}  // namespace kushi
