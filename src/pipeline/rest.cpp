// SPDX-License-Identifier: Apache-2.0
#include "pipeline/rest.h"

#include "pipeline/cut.h"
#include "pipeline/grow.h"
#include "pipeline/root_shares.h"

#include <algorithm>
#include <cmath>
#include <numeric>

namespace kushi {

namespace {

constexpr double mostTurn = 2.2;  // rad in one segment

// What a strand has become.
struct Strand {
    std::vector<Vec3d> nodes;  // as far as they are to be seen
    float residual = 0;
    bool settled = true;
};

class PartAtRest {
public:
    PartAtRest(const Style& style, const Part& part, const Follicles& follicles, int segments,
               int threads)
        : style_(style),
          part_(part),
          follicles_(follicles),
          sizes_(uncut(part.hair, follicles, segments)),
          strands_(follicles.size()),
          threads_(threads) {}

    Status settle(std::span<const std::uint32_t> which) {
        const Rods rods = grow(part_, follicles_, sizes_, which, style_.solver.grading);
        if (const double turn = largestTurn(rods); turn > mostTurn) return tooFewSegments(turn);
        const std::vector<float> shares =
            rootShares(part_.forces, picked(follicles_.angles, which));
        RodWorld world;
        world.gravity = style_.gravity;
        world.forces = part_.forces;
        world.rootShares = shares;
        world.obstacle = &part_.scalp.ellipsoid;
        RestState state;
        RestOptions options;
        options.threads = threads_;
        std::vector<Vec3f> nodes(rods.nodeCount());
        const RestReport report = settleRods(rods, world, state, nodes, options);
        for (std::size_t k = 0; k < which.size(); ++k) {
            Strand& strand = strands_[which[k]];
            strand.nodes.clear();
            for (std::size_t j = 0; j <= rods.segments(k); ++j)
                strand.nodes.push_back(nodes[rods.firstNode(k) + j].as<double>());
            strand.residual = report.residuals[k];
            strand.settled = true;
        }
        for (const std::uint32_t k : report.unsettled)
            strands_[which[k]].settled = false;
        return std::monostate{};
    }

    // Shortens what the cut meets; returns those whose shape it changes.
    std::vector<std::uint32_t> cut(const Cut& cut) {
        std::vector<std::uint32_t> changed;
        for (std::uint32_t i = 0; i < strands_.size(); ++i) {
            std::vector<Vec3d>& nodes = strands_[i].nodes;
            const double rootShare = share(cut.roots, follicles_.angles[i], cut.falloff.angle);
            if (nodes.empty() || rootShare <= 0) continue;
            const auto left = lengthLeft(cut, nodes, cutPlace(follicles_.keys[i]), rootShare);
            if (!left) continue;
            if (*left <= 0) {
                nodes.clear();
            } else if (cut.mode == CutMode::Hide) {
                nodes = clipped(nodes, *left);
            } else {
                const double segment = sizes_.lengths[i] / static_cast<double>(sizes_.segments[i]);
                sizes_.lengths[i] = *left;
                sizes_.segments[i] =
                    static_cast<std::size_t>(std::max(1.0, std::ceil(*left / segment - 1e-9)));
                changed.push_back(i);
            }
        }
        return changed;
    }

    RestedPart take() const {
        RestedPart part;
        for (const Strand& strand : strands_) {
            for (const Vec3d node : strand.nodes)
                part.nodes.push_back(node.as<float>());
            part.offsets.push_back(static_cast<std::uint32_t>(part.nodes.size()));
            if (strand.nodes.empty()) continue;
            part.maxResidual = std::max(part.maxResidual, static_cast<double>(strand.residual));
            part.unsettled += strand.settled ? 0 : 1;
        }
        return part;
    }

private:
    Problem tooFewSegments(double turn) const {
        const auto longest = *std::ranges::max_element(sizes_.segments);
        const auto needed = std::ceil(static_cast<double>(longest) * turn / 1.5);
        return Problem{"the hair of '" + part_.name + "' winds by " +
                       std::to_string(std::lround(degrees(turn))) +
                       " degrees in a segment, which is too coarse; give [solver] segments = " +
                       std::to_string(static_cast<int>(needed)) +
                       (needed > 256 ? " (256 at most: a wider curl or shorter hair)" : "")};
    }

    const Style& style_;
    const Part& part_;
    const Follicles& follicles_;
    Sizes sizes_;
    std::vector<Strand> strands_;
    int threads_;
};

}  // namespace

Result<RestedPart> restPart(const Style& style, const Part& part, const Follicles& follicles,
                            int segments, int threads) {
    PartAtRest rest(style, part, follicles, segments, threads);
    std::vector<std::uint32_t> which(follicles.size());
    std::iota(which.begin(), which.end(), 0U);
    if (const Status settled = rest.settle(which); !settled) return settled.problems();
    for (const Cut& cut : part.cuts) {
        which = rest.cut(cut);
        if (which.empty()) continue;
        if (const Status settled = rest.settle(which); !settled) return settled.problems();
    }
    return rest.take();
}

}  // namespace kushi
