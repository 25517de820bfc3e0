// SPDX-License-Identifier: Apache-2.0
#include "geometry/field_solid.h"

#include "core/parallel.h"
#include "geometry/closed_surface.h"
#include "geometry/field_blocks.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace kushi {
namespace {

constexpr int side = FieldBlocks::side;

/// How far from a solid distances are exact, at least [m].
constexpr float exactReach = 0.02F;
/// And at least so many spacings: from there on the points nearest to the blocks around are as good
/// as exact, within 0.3 of a spacing.
constexpr float exactSpacings = 8;

/// The samples of a block, each beside the one before.
std::array<std::array<int, 3>, side * side * side> windingWay() {
    std::array<std::array<int, 3>, side * side * side> way{};
    std::size_t n = 0;
    const auto turned = [](int i, bool back) { return back ? side - 1 - i : i; };
    for (int k = 0; k < side; ++k) {
        for (int j = 0; j < side; ++j) {
            for (int i = 0; i < side; ++i) {
                const int y = turned(j, k % 2 == 1);
                way[n++] = {turned(i, (k * side + j) % 2 == 1), y, k};
            }
        }
    }
    return way;
}

float distanceTo(const std::vector<Vec3f>& points, Vec3f place) {
    float least = std::numeric_limits<float>::max();
    for (const Vec3f point : points)
        least = std::min(least, dot(place - point, place - point));
    return std::sqrt(least);
}

class SolidSampler {
public:
    SolidSampler(DistanceField& field, const TriangleTree& tree, const FieldBlocks& blocks,
                 float offset, std::uint8_t solid)
        : field_(field),
          tree_(tree),
          blocks_(blocks),
          offset_(offset),
          solid_(solid),
          reach_(std::max(exactReach, exactSpacings * field.spacing) + std::abs(offset)) {}

    void sample(int blockX, int blockY, int blockZ) {
        const Probe& middle = blocks_.middles[blocks_.index(blockX, blockY, blockZ)];
        const std::vector<Vec3f> around = pointsAround(blocks_, blockX, blockY, blockZ);
        std::array<Probe, 2> nearby = {middle, middle};  // and the sample before
        static const auto way = windingWay();
        for (const auto& [i, j, k] : way) {
            const int x = side * blockX + i, y = side * blockY + j, z = side * blockZ + k;
            if (x >= field_.size[0] || y >= field_.size[1] || z >= field_.size[2]) continue;
            const Vec3f place =
                field_.origin + field_.spacing * Vec3f{static_cast<float>(x), static_cast<float>(y),
                                                       static_cast<float>(z)};
            if (middle.nearest.distance - length(place - middle.place) > reach_) {
                store(field_.index(x, y, z), distanceTo(around, place), middle.inside);
            } else {
                nearby[1] = probeAt(tree_, place, nearby);
                store(field_.index(x, y, z), nearby[1].nearest.distance, nearby[1].inside);
            }
        }
    }

private:
    void store(std::size_t sample, float distance, bool inside) {
        constexpr float most = std::numeric_limits<std::int16_t>::max();
        const float units = ((inside ? -distance : distance) - offset_) / field_.unit();
        const auto rounded = static_cast<std::int16_t>(std::lround(std::clamp(units, -most, most)));
        if (rounded >= field_.units[sample]) return;
        field_.units[sample] = rounded;
        if (!field_.nearest.empty()) field_.nearest[sample] = solid_;
    }

    DistanceField& field_;
    const TriangleTree& tree_;
    const FieldBlocks& blocks_;
    float offset_;
    std::uint8_t solid_;
    float reach_;
};

}  // namespace

void addSolid(DistanceField& field, const Solid& solid, std::uint8_t index, int threads) {
    const TriangleTree tree = treeOf(closedSurface(solid.mesh));
    if (tree.nodes.empty()) return;
    const FieldBlocks blocks = blocksOf(field, tree, threads);
    SolidSampler sampler(field, tree, blocks, static_cast<float>(solid.offset), index);
    parallelFor(blocks.middles.size(), 16, threads, [&](std::size_t begin, std::size_t end) {
        const auto columns = static_cast<std::size_t>(blocks.size[0]);
        const auto rows = static_cast<std::size_t>(blocks.size[1]);
        for (std::size_t i = begin; i < end; ++i) {
            sampler.sample(static_cast<int>(i % columns), static_cast<int>(i / columns % rows),
                           static_cast<int>(i / columns / rows));
        }
    });
}

}  // namespace kushi
