// SPDX-License-Identifier: Apache-2.0
#include "pipeline/settle_part.h"

#include "core/parallel.h"
#include "pipeline/cut.h"
#include "pipeline/grow.h"
#include "pipeline/lay_under.h"
#include "pipeline/lead.h"
#include "pipeline/part_world.h"
#include "pipeline/push_all_out.h"
#include "pipeline/root_shares.h"
#include "pipeline/tie_up.h"

#include <kushi/cantilevers.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <numeric>
#include <string>

namespace kushi {

namespace {

constexpr double mostTurn = 2.2;  // rad in one segment

// Forces in boxes, ties and what hair lies on hold it about as much again as its weight does.
constexpr float held = 2;

constexpr double everything = std::numeric_limits<double>::infinity();

// Hair that is closer than voxels can tell needs many small steps to come apart: few long ones do
// as well, but for those that nothing would end.
Vec3f hasty(Vec3f way) {
    constexpr float haste = 6;
    constexpr float longest = 0.01F;  // m
    const float size = haste * length(way);
    return (size > longest ? haste * longest / size : haste) * way;
}

// How a strand came to rest.
struct Outcome {
    float residual = 0;
    bool settled = true;
};

// Strands that are settled together.
struct Group {
    std::vector<std::uint32_t> which;  // of the part's
    Rods rods;
    std::vector<float> shares;  // in the forces
    std::vector<Layer> layers;
    std::vector<Tie> ties;
    std::vector<Vec3f> loads;
    RestState state;
    std::size_t first = 0;  // node
};

}  // namespace

class PartHair::Progress {
public:
    Progress(const Style& style, const Part& part, const Follicles& follicles,
             const PartSettling& how)
        : style_(style),
          part_(part),
          follicles_(follicles),
          how_(how),
          sizes_(uncut(part.hair, follicles, how.segments)),
          outcomes_(follicles.size()),
          groupOf_(follicles.size()),
          seen_(follicles.size(), everything) {
        settled_.stretches.resize(follicles.size());
    }

    Status settle() {
        std::vector<std::uint32_t> which(follicles_.size());
        std::iota(which.begin(), which.end(), 0U);
        if (Status settled = settle(which); !settled) return settled;
        for (const Cut& cut : part_.cuts) {
            which = this->cut(cut);
            if (which.empty()) continue;
            if (Status settled = settle(which); !settled) return settled;
        }
        return std::monostate{};
    }

    void lead(const Spreading& spreading) {
        for (Group& group : groups_)
            lead(spreading, group);
    }

    Status settleAgain() {
        for (Group& group : groups_) {
            if (Status rested = rest(group, true); !rested) return rested;
            if (!letGo(group)) continue;
            if (Status rested = rest(group, true); !rested) return rested;
        }
        for (std::uint32_t i = 0; i < follicles_.size(); ++i) {
            if (settled_.stretches[i].count == 0 || seen_[i] == everything) continue;
            const Group& group = groups_[groupOf_[i]];
            const auto place = std::ranges::lower_bound(group.which, i) - group.which.begin();
            settled_.stretches[i].count = group.rods.segments(static_cast<std::size_t>(place)) + 1;
            hide(i, nodesOf(i), seen_[i]);
        }
        return std::monostate{};
    }

    std::vector<std::span<const Vec3f>> strands() const {
        std::vector<std::span<const Vec3f>> all;
        for (std::size_t i = 0; i < follicles_.size(); ++i) {
            if (settled_.stretches[i].count > 1) all.push_back(settled_.strand(i));
        }
        return all;
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
    Status settle(std::span<const std::uint32_t> which) {
        std::vector<std::uint32_t> tied;
        std::vector<std::uint32_t> covered;
        std::vector<std::uint32_t> loose;
        std::vector<WayToTie> ways;
        for (const std::uint32_t i : which) {
            auto way = wayToTie(part_, follicles_.roots[i], follicles_.angles[i],
                                follicles_.keys[i], sizes_.lengths[i]);
            (way ? tied : isUnderCollider(i) ? covered : loose).push_back(i);
            if (way) ways.push_back(std::move(*way));
        }
        if (Status settled = settleAlike(loose, Start::Grown); !settled) return settled;
        if (Status settled = settleAlike(covered, Start::Laid); !settled) return settled;
        return settleAlike(tied, Start::Tied, ways);
    }

    bool isUnderCollider(std::uint32_t i) const {
        return how_.method == Method::Equilibrium && !style_.colliders.empty() &&
               isCovered(*how_.solids, follicles_.roots[i], follicles_.normals[i]);
    }

    // Shortens what the cut meets; returns those whose shape it changes.
    std::vector<std::uint32_t> cut(const Cut& cut) {
        std::vector<std::uint32_t> changed;
        for (std::uint32_t i = 0; i < follicles_.size(); ++i) {
            const double rootShare = share(cut.roots, follicles_.angles[i], cut.falloff.angle);
            SettledPart::Stretch& stretch = settled_.stretches[i];
            if (stretch.count == 0 || rootShare <= 0) continue;
            const std::vector<Vec3d> nodes = nodesOf(i);
            const auto left = lengthLeft(cut, nodes, cutPlace(follicles_.keys[i]), rootShare);
            if (!left) continue;
            if (*left <= 0) {
                stretch.count = 0;
            } else if (cut.mode == CutMode::Hide) {
                seen_[i] = *left;
                hide(i, nodes, *left);
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

    enum class Start { Grown, Laid, Tied };

    // Those that begin alike: as they grow, laid under what covers them, or on their ways to a tie.
    Status settleAlike(std::span<const std::uint32_t> which, Start start,
                       std::span<const WayToTie> ways = {}) {
        if (which.empty()) return std::monostate{};
        Group group;
        group.which.assign(which.begin(), which.end());
        // The walk knows equal segments only.
        const double grading = how_.method == Method::Cantilever ? 1 : style_.solver.grading;
        group.rods = grow(part_, follicles_, sizes_, which, grading);
        const std::vector<EllipsoidAngles> angles = picked(follicles_.angles, which);
        group.shares = rootShares(part_.forces, angles);
        group.layers = how_.layers.of(angles);
        if (start == Start::Laid) layUnder(part_.scalp.ellipsoid, style_.gravity, group.rods);
        if (start == Start::Tied) group.ties = layAlong(ways, style_.gravity, group.rods);
        group.first = settled_.nodes.size();
        settled_.nodes.resize(group.first + group.rods.nodeCount());
        for (std::size_t k = 0; k < which.size(); ++k) {
            groupOf_[which[k]] = groups_.size();
            settled_.stretches[which[k]] = {group.first + group.rods.firstNode(k),
                                            group.rods.segments(k) + 1};
        }
        if (how_.method == Method::Equilibrium) {
            if (Status rested = rest(group, false); !rested) return rested;
        } else {
            bendCantilevers(group.rods, worldOf(group), nodesOf(group),
                            {style_.solver.avoidanceSteps, how_.threads});
        }
        if (how_.again) groups_.push_back(std::move(group));
        return std::monostate{};
    }

    RodWorld worldOf(const Group& group) const {
        RodWorld world = kushi::worldOf(style_, part_, how_.solids, how_.frictions);
        world.rootShares = group.shares;
        world.layers = group.layers;
        world.ties = group.ties;
        world.loads = group.loads;
        return world;
    }

    std::span<Vec3f> nodesOf(const Group& group) {
        return std::span(settled_.nodes).subspan(group.first, group.rods.nodeCount());
    }

    Status rest(Group& group, bool warm) {
        if (const double turn = largestTurn(group.rods); turn > mostTurn)
            return tooFewSegments(turn);
        RestOptions options;
        options.warm = warm;
        options.refine = !warm;
        options.threads = how_.threads;
        const RestReport report =
            settleRods(group.rods, worldOf(group), group.state, nodesOf(group), options);
        const auto current = [&](std::size_t k) { return !warm || isLatest(group, k); };
        for (std::size_t k = 0; k < group.which.size(); ++k)
            if (current(k)) outcomes_[group.which[k]] = {report.residuals[k], true};
        for (const std::uint32_t k : report.unsettled)
            if (current(k)) outcomes_[group.which[k]].settled = false;
        return std::monostate{};
    }

    void lead(const Spreading& spreading, Group& group) {
        const Rods& rods = group.rods;
        group.loads.resize(rods.offsets.back());
        parallelFor(rods.size(), 256, how_.threads, [&](std::size_t begin, std::size_t end) {
            std::vector<Vec3f> ways;
            for (std::size_t k = begin; k < end; ++k) {
                if (!isLatest(group, k)) continue;
                const auto nodes = nodesOf(group).subspan(rods.firstNode(k), rods.segments(k) + 1);
                ways.clear();
                for (const Vec3f node : nodes)
                    ways.push_back(hasty(spreading.way(node)));
                if (std::ranges::all_of(ways, [](Vec3f way) { return way == Vec3f{}; })) continue;
                kushi::lead(nodes, ways, std::cbrt(rods.bending[k] / rods.weights[k]), held,
                            loadsOf(group, k));
            }
        });
    }

    // What does not come to rest where it is led; whether there is any.
    bool letGo(Group& group) {
        bool any = false;
        for (std::size_t k = 0; k < group.which.size(); ++k) {
            if (!isLatest(group, k) || outcomes_[group.which[k]].settled) continue;
            std::ranges::fill(loadsOf(group, k), Vec3f{});
            any = true;
        }
        return any;
    }

    // Whether no cut has made another of a strand since, nor taken all of it.
    bool isLatest(const Group& group, std::size_t k) const {
        const std::uint32_t i = group.which[k];
        return &groups_[groupOf_[i]] == &group && settled_.stretches[i].count > 0;
    }

    static std::span<Vec3f> loadsOf(Group& group, std::size_t k) {
        return std::span(group.loads).subspan(group.rods.offsets[k], group.rods.segments(k));
    }

    std::vector<Vec3d> nodesOf(std::size_t strand) const {
        std::vector<Vec3d> nodes;
        for (const Vec3f node : settled_.strand(strand))
            nodes.push_back(node.as<double>());
        return nodes;
    }

    // All but so much of a strand.
    void hide(std::size_t strand, const std::vector<Vec3d>& nodes, double left) {
        const std::vector<Vec3d> visible = clipped(nodes, left);
        SettledPart::Stretch& stretch = settled_.stretches[strand];
        stretch.count = visible.size();
        settled_.nodes[stretch.first + stretch.count - 1] = visible.back().as<float>();
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
    PartSettling how_;
    Sizes sizes_;
    SettledPart settled_;
    std::vector<Outcome> outcomes_;
    std::vector<Group> groups_;         // if they are settled again
    std::vector<std::size_t> groupOf_;  // a strand's latest
    std::vector<double> seen_;          // how much of a strand hide cuts leave [m]
};

PartHair::PartHair(const Style& style, const Part& part, const Follicles& follicles,
                   const PartSettling& how)
    : progress_(std::make_unique<Progress>(style, part, follicles, how)) {}
PartHair::~PartHair() = default;
PartHair::PartHair(PartHair&&) noexcept = default;

Status PartHair::settle() {
    return progress_->settle();
}

std::vector<std::span<const Vec3f>> PartHair::strands() const {
    return progress_->strands();
}

void PartHair::lead(const Spreading& spreading) {
    progress_->lead(spreading);
}

Status PartHair::settleAgain() {
    return progress_->settleAgain();
}

SettledPart PartHair::take() {
    return progress_->take();
}

}  // namespace kushi
