// SPDX-License-Identifier: Apache-2.0
#include "pipeline/settle_part.h"

#include "pipeline/cut.h"
#include "pipeline/grow.h"
#include "pipeline/layers.h"
#include "pipeline/push_all_out.h"
#include "pipeline/root_shares.h"
#include "pipeline/tie_up.h"

#include <kushi/cantilevers.h>

#include <algorithm>
#include <cmath>
#include <numeric>
#include <string>

namespace kushi {

namespace {

constexpr double mostTurn = 2.2;  // rad in one segment

// Of hair that lies on hair, unless the style says otherwise: share of the space that it fills.
constexpr double lyingPacking = 0.15;

// How a strand came to rest.
struct Outcome {
    float residual = 0;
    bool settled = true;
};

class PartInProgress {
public:
    PartInProgress(const Style& style, const Part& part, const Follicles& follicles,
                   const PartSettling& how)
        : style_(style),
          part_(part),
          follicles_(follicles),
          how_(how),
          sizes_(uncut(part.hair, follicles, how.segments)),
          outcomes_(follicles.size()) {
        settled_.stretches.resize(follicles.size());
        if (style.contact.layers && how.method == Method::Equilibrium) {
            layers_ = layersOf(part.scalp.ellipsoid, follicles, part.hair.diameter,
                               style.contact.packing.value_or(lyingPacking));
        }
    }

    Status settle(std::span<const std::uint32_t> which) {
        std::vector<std::uint32_t> tied;
        std::vector<std::uint32_t> loose;
        std::vector<WayToTie> ways;
        for (const std::uint32_t i : which) {
            auto way = wayToTie(part_, follicles_.roots[i], follicles_.angles[i],
                                follicles_.keys[i], sizes_.lengths[i]);
            (way ? tied : loose).push_back(i);
            if (way) ways.push_back(std::move(*way));
        }
        if (Status settled = settleAlike(loose, {}); !settled) return settled;
        return settleAlike(tied, ways);
    }

    // Shortens what the cut meets; returns those whose shape it changes.
    std::vector<std::uint32_t> cut(const Cut& cut) {
        std::vector<std::uint32_t> changed;
        std::vector<Vec3d> nodes;
        for (std::uint32_t i = 0; i < follicles_.size(); ++i) {
            const double rootShare = share(cut.roots, follicles_.angles[i], cut.falloff.angle);
            SettledPart::Stretch& stretch = settled_.stretches[i];
            if (stretch.count == 0 || rootShare <= 0) continue;
            nodes.clear();
            for (const Vec3f node : settled_.strand(i))
                nodes.push_back(node.as<double>());
            const auto left = lengthLeft(cut, nodes, cutPlace(follicles_.keys[i]), rootShare);
            if (!left) continue;
            if (*left <= 0) {
                stretch.count = 0;
            } else if (cut.mode == CutMode::Hide) {
                const std::vector<Vec3d> visible = clipped(nodes, *left);
                stretch.count = visible.size();
                settled_.nodes[stretch.first + stretch.count - 1] = visible.back().as<float>();
            } else {
                const double segment = grownLength(part_.hair, follicles_.keys[i]) / how_.segments;
                sizes_.lengths[i] = *left;
                sizes_.segments[i] =
                    static_cast<std::size_t>(std::max(1.0, std::ceil(*left / segment - 1e-9)));
                changed.push_back(i);
            }
        }
        return changed;
    }

    SettledPart take() {
        if (how_.solids != nullptr) {
            const auto strand = [this](std::size_t i) {
                const auto [first, count] = settled_.stretches[i];
                return std::span(settled_.nodes).subspan(first, count);
            };
            const PushOutReport out =
                pushAllOut(*how_.solids, follicles_.size(), strand, how_.threads);
            settled_.pushedOut = out.pushed;
            settled_.stuck = out.stuck;
        }
        for (std::size_t i = 0; i < outcomes_.size(); ++i) {
            if (settled_.stretches[i].count == 0) continue;
            const Outcome& outcome = outcomes_[i];
            settled_.maxResidual =
                std::max(settled_.maxResidual, static_cast<double>(outcome.residual));
            settled_.unsettled += outcome.settled ? 0 : 1;
        }
        return std::move(settled_);
    }

private:
    // Those that no tie holds, or those that go their ways to one.
    Status settleAlike(std::span<const std::uint32_t> which, std::span<const WayToTie> ways) {
        if (which.empty()) return std::monostate{};
        // The walk knows equal segments only.
        const double grading = how_.method == Method::Cantilever ? 1 : style_.solver.grading;
        Rods rods = grow(part_, follicles_, sizes_, which, grading);
        const std::vector<float> shares =
            rootShares(part_.forces, picked(follicles_.angles, which));
        RodWorld world;
        world.gravity = style_.gravity;
        world.forces = part_.forces;
        world.rootShares = shares;
        // Hair that grows from a head below or above the ellipsoid is not kept out of that.
        if (part_.scalp.surface == ScalpSurface::Ellipsoid) world.obstacle = &part_.scalp.ellipsoid;
        world.solids = how_.solids;
        const std::vector<Layer> layers = layers_.empty() ? layers_ : picked(layers_, which);
        world.layers = layers;
        const std::vector<Tie> ties = layAlong(ways, style_.gravity, rods);
        world.ties = ties;

        const std::size_t base = settled_.nodes.size();
        settled_.nodes.resize(base + rods.nodeCount());
        for (std::size_t k = 0; k < which.size(); ++k)
            settled_.stretches[which[k]] = {base + rods.firstNode(k), rods.segments(k) + 1};
        const auto nodes = std::span(settled_.nodes).subspan(base);
        if (how_.method == Method::Equilibrium) return rest(which, rods, world, nodes);
        bendCantilevers(rods, world, nodes, {style_.solver.avoidanceSteps, how_.threads});
        return std::monostate{};
    }

    Status rest(std::span<const std::uint32_t> which, const Rods& rods, const RodWorld& world,
                std::span<Vec3f> nodes) {
        if (const double turn = largestTurn(rods); turn > mostTurn) return tooFewSegments(turn);
        RestState state;
        RestOptions options;
        options.threads = how_.threads;
        const RestReport report = settleRods(rods, world, state, nodes, options);
        for (std::size_t k = 0; k < which.size(); ++k)
            outcomes_[which[k]] = {report.residuals[k], true};
        for (const std::uint32_t k : report.unsettled)
            outcomes_[which[k]].settled = false;
        return std::monostate{};
    }

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
    const PartSettling& how_;
    std::vector<Layer> layers_;  // of each follicle; none: hair lies on the skin
    Sizes sizes_;
    SettledPart settled_;
    std::vector<Outcome> outcomes_;
};

}  // namespace

Result<SettledPart> settlePart(const Style& style, const Part& part, const Follicles& follicles,
                               const PartSettling& how) {
    PartInProgress progress(style, part, follicles, how);
    std::vector<std::uint32_t> which(follicles.size());
    std::iota(which.begin(), which.end(), 0U);
    if (const Status settled = progress.settle(which); !settled) return settled.problems();
    for (const Cut& cut : part.cuts) {
        which = progress.cut(cut);
        if (which.empty()) continue;
        if (const Status settled = progress.settle(which); !settled) return settled.problems();
    }
    return progress.take();
}

}  // namespace kushi
