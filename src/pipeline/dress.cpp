// SPDX-License-Identifier: Apache-2.0
#include "pipeline/dress.h"

#include "core/parallel.h"
#include "core/random.h"
#include "core/smooth_step.h"
#include "pipeline/aside.h"
#include "pipeline/flyaway.h"
#include "pipeline/penetration.h"
#include "pipeline/push_all_out.h"
#include "pipeline/retrace.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <numbers>

namespace kushi {

namespace {

constexpr std::size_t together = 64;  // strands of one thread
constexpr std::uint64_t amountSalt = 0x616d6f756e74;
constexpr std::uint64_t straySalt = 0x7374726179;
constexpr double mostDrawn = 0.95;
// Whole clumps stray by so much of what their tips would be drawn by at the distance of a size, in
// waves from the shortest to twice as long [m].
constexpr double straying = 0.5;
constexpr double shortestWave = 0.06;
constexpr double diametersApart = 2;
// Sizes by which a strand parts from its guide: up to the first it is drawn as it should be, beyond
// the second not at all.
constexpr double parting = 3;
constexpr double parted = 6;

constexpr std::uint32_t none = std::numeric_limits<std::uint32_t>::max();

// Places by the way from the root.
class Path {
public:
    explicit Path(std::span<const Vec3f> nodes) {
        for (const Vec3f node : nodes) {
            const Vec3d place = node.as<double>();
            ways_.push_back(nodes_.empty() ? 0 : ways_.back() + length(place - nodes_.back()));
            nodes_.push_back(place);
        }
    }

    double whole() const { return ways_.back(); }
    double way(std::size_t node) const { return ways_[node]; }
    const std::vector<Vec3d>& nodes() const { return nodes_; }

    // The tip, beyond it.
    Vec3d at(double way) const {
        if (way >= whole()) return nodes_.back();
        const auto after = static_cast<std::size_t>(
            std::ranges::upper_bound(ways_, std::max(way, 0.0)) - ways_.begin());
        const double share = (way - ways_[after - 1]) / (ways_[after] - ways_[after - 1]);
        return nodes_[after - 1] + share * (nodes_[after] - nodes_[after - 1]);
    }

private:
    std::vector<Vec3d> nodes_;
    std::vector<double> ways_;
};

// How far two strands part, on the way that both go.
double partingOf(const Path& a, const Path& b) {
    const double both = std::min(a.whole(), b.whole());
    double most = 0;
    for (const double share : {0.0, 0.25, 0.5, 0.75, 1.0})
        most = std::max(most, length(a.at(share * both) - b.at(share * both)));
    return most;
}

// The waves in which a whole clump strays.
class Stray {
public:
    explicit Stray(std::uint64_t clumpKey) {
        for (std::size_t i = 0; i < waves_.size(); ++i) {
            const std::uint64_t key = mixKey(clumpKey, straySalt + i);
            waves_[i] = {2 * std::numbers::pi * uniform(mixKey(key, 1)),
                         2 * std::numbers::pi / (shortestWave * (1 + uniform(mixKey(key, 2))))};
        }
    }

    // So far along, by 1 at most outwards and to each side; never inwards.
    Vec3d at(double way, const Aside& aside) const {
        const auto sine = [&](std::size_t i) {
            return std::sin(waves_[i].phase + waves_[i].number * way);
        };
        return (0.5 + 0.5 * sine(0)) * aside.outward + sine(1) * aside.sideways;
    }

private:
    struct Wave {
        double phase = 0, number = 0;  // rad, rad/m
    };
    std::array<Wave, 2> waves_;
};

class Clumping {
public:
    Clumping(const Hair& hair, const ClumpCentres& centres, Vec3d middle,
             const StrandsAtRest& atRest, int threads)
        : hair_(hair), centres_(centres), middle_(middle), guides_(centres.size(), none) {
        findGuides(atRest, threads);
        for (const std::uint32_t guide : guides_)
            paths_.emplace_back(guide == none ? std::span<const Vec3f>(&nowhere, 1)
                                              : atRest.strands[guide]);
    }

    // The clump that a strand belongs to; none: it grows too far from all.
    std::uint32_t clumpOf(const Path& path) const {
        std::uint32_t best = none;
        double least = parted * hair_.clump.size;
        for (const std::uint32_t clump : centres_.around(path.nodes()[0])) {
            if (guides_[clump] == none) continue;
            const double found = partingOf(path, paths_[clump]);
            if (found >= least) continue;
            least = found;
            best = clump;
        }
        return best;
    }

    // Where a strand's nodes go.
    std::vector<Vec3d> drawn(const Path& path, std::uint64_t key, std::uint32_t clump,
                             double ease) const {
        const Path& guide = paths_[clump];
        const double size = hair_.clump.size;
        const double near =
            ease * (1 - smoothStep(parting * size, parted * size, partingOf(path, guide)));
        const double amount = near * amountOf(key, clump);
        const double far = near * straying * amountOf(clump) * size;
        const Stray stray(centres_.key(clump));
        std::vector<Vec3d> wanted = path.nodes();
        for (std::size_t j = 1; j < wanted.size(); ++j) {
            const double share = path.way(j) / path.whole();
            const double from = hair_.clump.from;
            // Beyond the guide's tip as it was there.
            const double way = std::min(path.way(j), guide.whole());
            const Vec3d across = guide.at(way) - path.at(way);
            wanted[j] += std::min(amount * smoothStep(from, 1, share), room(across)) * across;
            const Vec3d tangent = guide.at(way + nearby) - guide.at(way - nearby);
            wanted[j] += far * smoothStep(from, (1 + from) / 2, share) *
                         stray.at(way, asideOf(guide.at(way), tangent, middle_));
        }
        return wanted;
    }

private:
    double amountOf(std::uint32_t clump) const {
        const Clump& wanted = hair_.clump;
        const double ofClump = uniformSigned(mixKey(centres_.key(clump), amountSalt));
        return wanted.amount * (1 + wanted.variation * ofClump);
    }
    double amountOf(std::uint64_t key, std::uint32_t clump) const {
        const double ofStrand = uniformSigned(mixKey(key, amountSalt));
        return std::min(mostDrawn, amountOf(clump) * (1 + 0.5 * hair_.clump.variation * ofStrand));
    }

    // The share of the way to the guide up to where two hairs have room.
    double room(Vec3d across) const {
        const double away = length(across);
        return away > 0 ? 1 - std::min(1.0, diametersApart * hair_.diameter / away) : 0;
    }

    void findGuides(const StrandsAtRest& atRest, int threads) {
        struct Nearest {
            std::uint32_t clump = none;
            double distance = 0;
        };
        std::vector<Nearest> nearest(atRest.strands.size());
        parallelFor(nearest.size(), together, threads, [&](std::size_t begin, std::size_t end) {
            for (std::size_t i = begin; i < end; ++i) {
                if (atRest.strands[i].size() < 2) continue;
                const Vec3d root = atRest.strands[i][0].as<double>();
                for (const std::uint32_t clump : centres_.around(root)) {
                    const double distance = length(centres_.point(clump) - root);
                    if (nearest[i].clump == none || distance < nearest[i].distance)
                        nearest[i] = {clump, distance};
                }
            }
        });
        std::vector<double> least(centres_.size(), std::numeric_limits<double>::infinity());
        for (std::uint32_t i = 0; i < nearest.size(); ++i) {
            const auto [clump, distance] = nearest[i];
            if (clump == none || distance >= least[clump]) continue;
            least[clump] = distance;
            guides_[clump] = i;
        }
    }

    static constexpr Vec3f nowhere = {};
    static constexpr double nearby = 0.005;  // m along a guide

    const Hair& hair_;
    const ClumpCentres& centres_;
    Vec3d middle_;
    std::vector<std::uint32_t> guides_;  // strands, by clump
    std::vector<Path> paths_;            // of the guides
};

// Whether a strand is, or has been brought, outside of what it stays out of; or lies no deeper than
// it did.
bool keptOut(const Obstacles& obstacles, std::span<const Vec3f> before, std::span<Vec3f> nodes) {
    if (obstacles.solids != nullptr) return pushOneOut(*obstacles.solids, nodes) != Pushed::Stuck;
    if (obstacles.ellipsoid == nullptr) return true;
    constexpr double harmless = insideFrom / 2;
    const double depth = deepestPoint(obstacles, nodes);
    return depth <= harmless || depth <= deepestPoint(obstacles, before);
}

// What a strand is to become.
struct Wish {
    bool flies = false;
    std::uint32_t clump = none;

    bool any() const { return flies || clump != none; }
};

class Dressing {
public:
    Dressing(const Hair& hair, const ClumpCentres& centres, Vec3d middle,
             const Obstacles& obstacles, const StrandsAtRest& atRest, int threads)
        : hair_(hair),
          middle_(middle),
          obstacles_(obstacles),
          atRest_(atRest),
          clumping_(hair, centres, middle, atRest, threads) {}

    // What became of a strand; nothing where there is no room.
    Wish dress(std::uint32_t i) const {
        const std::span<Vec3f> nodes = atRest_.strands[i];
        if (nodes.size() < 2) return {};
        const Path path(nodes);
        const Wish wish = wishOf(i, path);
        if (!wish.any()) return {};
        const std::vector<Vec3f> before(nodes.begin(), nodes.end());
        for (const double ease : {1.0, 0.5, 0.25, 0.125}) {
            if (wish.flies) {
                Flyaway less = hair_.flyaway;
                less.distance *= ease;
                flyAway(less, atRest_.keys[i], middle_, nodes);
            } else {
                retrace(clumping_.drawn(path, atRest_.keys[i], wish.clump, ease), 1, nodes);
            }
            if (keptOut(obstacles_, before, nodes)) return wish;
            std::ranges::copy(before, nodes.begin());
        }
        return {};
    }

private:
    Wish wishOf(std::uint32_t i, const Path& path) const {
        if (!(path.whole() > 0)) return {};
        if (isFlyaway(hair_.flyaway, atRest_.keys[i])) return {true, none};
        return {false, clumping_.clumpOf(path)};
    }

    const Hair& hair_;
    Vec3d middle_;
    const Obstacles& obstacles_;
    const StrandsAtRest& atRest_;
    Clumping clumping_;
};

}  // namespace

DressReport dress(const Hair& hair, const ClumpCentres& centres, Vec3d middle,
                  const Obstacles& obstacles, const StrandsAtRest& atRest, int threads) {
    const Dressing dressing(hair, centres, middle, obstacles, atRest, threads);
    std::vector<Wish> done(atRest.strands.size());
    parallelFor(done.size(), together, threads, [&](std::size_t begin, std::size_t end) {
        for (std::size_t i = begin; i < end; ++i)
            done[i] = dressing.dress(static_cast<std::uint32_t>(i));
    });
    DressReport report;
    std::vector<bool> gathers(centres.size());
    for (const Wish& wish : done) {
        report.flyaways += wish.flies ? 1 : 0;
        if (wish.clump != none) gathers[wish.clump] = true;
    }
    report.clumps = static_cast<std::size_t>(std::ranges::count(gathers, true));
    return report;
}

}  // namespace kushi
