// SPDX-License-Identifier: Apache-2.0
#include "pipeline/groom_part.h"

#include "pipeline/change.h"
#include "pipeline/cut.h"
#include "pipeline/root_shares.h"
#include "pipeline/set_outside.h"
#include "pipeline/stopwatch.h"

#include <algorithm>
#include <cmath>

namespace kushi {

namespace {

// A segment is not cut shorter than this share of it: the node before is the end then.
constexpr double leastSegment = 1e-3;

// Hair as a groom is set: ordinary, as thick as the part's.
Hair ordinary(const Hair& hair) {
    Hair set;
    set.diameter = hair.diameter;
    return set;
}

template <class T>
T between(T a, T b, double share) {
    const auto t = static_cast<float>(share);
    return (1 - t) * a + t * b;
}

Frame between(Frame a, Frame b, double share) {
    const auto t = static_cast<float>(share);
    const float side = a.w * b.w + a.x * b.x + a.y * b.y + a.z * b.z < 0 ? -1.0F : 1.0F;
    const float s = (1 - t);
    const Frame mixed = {s * a.w + side * t * b.w, s * a.x + side * t * b.x,
                         s * a.y + side * t * b.y, s * a.z + side * t * b.z};
    const float size =
        std::sqrt(mixed.w * mixed.w + mixed.x * mixed.x + mixed.y * mixed.y + mixed.z * mixed.z);
    return {mixed.w / size, mixed.x / size, mixed.y / size, mixed.z / size};
}

// A place along a strand is a number of segments of its rod as it was set, whole and a share.
struct Place {
    explicit Place(double segments)
        : node(static_cast<std::size_t>(segments)), share(segments - std::floor(segments)) {}

    std::size_t node;
    double share;  // of the way to the next node

    std::size_t segments() const { return node + (share > 0 ? 1 : 0); }
};

// What a strand has become.
struct Strand {
    std::vector<Vec3d> nodes;  // of its rod at rest
    double end = 0;            // the place of the last of them
    double shown = 0;          // the place up to which it is to be seen
    bool gone = false;
    float residual = 0;
    bool settled = true;
};

class PartAtRest {
public:
    PartAtRest(const Style& style, const Part& part, const Strands& groom, OutsideGroom set,
               const DistanceField* solids, std::span<const float> frictions, int threads)
        : style_(style),
          part_(part),
          groom_(groom),
          set_(std::move(set.set)),
          skins_(std::move(set.skins)),
          solids_(solids),
          frictions_(frictions),
          strands_(groom.size()),
          threads_(threads) {
        for (std::size_t i = 0; i < groom.size(); ++i) {
            angles_.push_back(part.scalp.ellipsoid.angles(groom.strand(i)[0].as<double>()));
            strands_[i].end = strands_[i].shown = static_cast<double>(set_.rods.segments(i));
        }
    }

    void settle(const std::function<void(double)>& progress) {
        const Hair set = ordinary(part_.hair);
        const std::vector<float> shares = rootShares(part_.forces, angles_);
        Change change;
        change.gravity = style_.gravity;
        change.weight = part_.hair.weightPerLength() / set.weightPerLength();
        change.bending = part_.hair.rigidity() / set.rigidity();
        change.twisting = part_.hair.torsionalRigidity() / set.torsionalRigidity();
        change.set = part_.hair.set;
        change.forces = part_.forces;
        change.rootShares = shares;
        change.solids = solids_;
        change.solidFrictions = frictions_;
        change.layers = skins_;
        ChangedGroom changed = settleChanged(set_, change, threads_, progress);
        rods_ = std::move(changed.rods);
        std::vector<std::uint32_t> all(strands_.size());
        for (std::uint32_t i = 0; i < all.size(); ++i)
            all[i] = i;
        take(all, rods_, changed.nodes, changed.report);
    }

    void cut(const Cut& cut) {
        std::vector<std::uint32_t> shortened;
        for (std::uint32_t i = 0; i < strands_.size(); ++i) {
            Strand& strand = strands_[i];
            const double rootShare = share(cut.roots, angles_[i], cut.falloff.angle);
            if (strand.gone || rootShare <= 0) continue;
            std::vector<Vec3d> nodes = visible(strand);
            const double clamp = clampOf(i);
            if (clamp > 0) nodes.insert(nodes.begin(), groom_.strand(i)[0].as<double>());
            const auto left = lengthLeft(cut, nodes, cutPlace(groom_.keys[i]), rootShare);
            if (!left) continue;
            strand.gone = *left <= 0;
            if (strand.gone) continue;
            strand.shown = std::min(strand.shown, placeAt(i, std::max(*left - clamp, 0.0)));
            if (cut.mode == CutMode::Hide) continue;
            shorten(i);
            shortened.push_back(i);
        }
        if (!shortened.empty()) settleAnew(shortened);
    }

    GroomPart finish() const {
        GroomPart part;
        part.holding = {set_.factors, set_.unstable.size(), set_.unheld.size()};
        for (std::size_t i = 0; i < strands_.size(); ++i) {
            if (strands_[i].gone) continue;
            add(i, part.strands);
            part.maxResidual =
                std::max(part.maxResidual, static_cast<double>(strands_[i].residual));
            part.unsettled += strands_[i].settled ? 0 : 1;
        }
        return part;
    }

private:
    void take(std::span<const std::uint32_t> which, const Rods& rods, std::span<const Vec3f> nodes,
              const RestReport& report) {
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
    }

    // How far a strand's rod begins from its root [m].
    double clampOf(std::size_t i) const {
        return length(strands_[i].nodes[0] - groom_.strand(i)[0].as<double>());
    }

    // Where so much of a strand's length ends.
    double placeAt(std::size_t i, double left) const {
        const std::size_t first = set_.rods.offsets[i];
        const std::size_t count = set_.rods.segments(i);
        for (std::size_t j = 0; j < count; ++j) {
            const double size = set_.rods.segmentLengths[first + j];
            if (left < size) return static_cast<double>(j) + left / size;
            left -= size;
        }
        return static_cast<double>(count);
    }

    // The point of a strand at a place that has a share.
    static Vec3d pointAt(const Strand& strand, Place place) {
        const Place end(strand.end);
        const bool last = place.node == end.node;
        const double share = last ? place.share / end.share : place.share;
        return strand.nodes[place.node] +
               share * (strand.nodes[place.node + 1] - strand.nodes[place.node]);
    }

    static std::vector<Vec3d> visible(const Strand& strand) {
        const Place shown(strand.shown);
        std::vector<Vec3d> nodes(
            strand.nodes.begin(),
            strand.nodes.begin() + static_cast<std::ptrdiff_t>(shown.node) + 1);
        if (shown.share > 0) nodes.push_back(pointAt(strand, shown));
        return nodes;
    }

    // What is not to be seen goes.
    void shorten(std::size_t i) {
        Strand& strand = strands_[i];
        Place end(strand.shown);
        if (end.node > 0 && end.share < leastSegment) end = Place(static_cast<double>(end.node));
        const double cutFrom = strand.end;
        strand.end = strand.shown = static_cast<double>(end.node) + end.share;
        const std::size_t first = rods_.offsets[i];
        double length = 0;
        if (end.share > 0) {
            const std::size_t j = first + end.node;
            const Place before(cutFrom);
            const double share = before.node == end.node ? end.share / before.share : end.share;
            const Frame& near = end.node > 0 ? rods_.starts[j - 1] : rods_.clamps[i];
            rods_.segmentLengths[j] *= static_cast<float>(share);
            rods_.chords[j] *= static_cast<float>(share);
            rods_.starts[j] = between(near, rods_.starts[j], share);
        }
        for (std::size_t j = first; j < first + end.segments(); ++j)
            length += rods_.segmentLengths[j];
        rods_.lengths[i] = static_cast<float>(length);
    }

    // The rods of some strands as far as they have been left.
    Rods rodsOf(std::span<const std::uint32_t> which) const {
        Rods some;
        for (const std::uint32_t i : which) {
            some.roots.push_back(rods_.roots[i]);
            some.clamps.push_back(rods_.clamps[i]);
            some.lengths.push_back(rods_.lengths[i]);
            some.bending.push_back(rods_.bending[i]);
            some.twisting.push_back(rods_.twisting[i]);
            some.weights.push_back(rods_.weights[i]);
            some.keys.push_back(rods_.keys[i]);
            const std::size_t begin = rods_.offsets[i];
            const std::size_t end = begin + Place(strands_[i].end).segments();
            for (std::size_t j = begin; j < end; ++j) {
                some.segmentLengths.push_back(rods_.segmentLengths[j]);
                some.naturalCurvature.push_back(rods_.naturalCurvature[j]);
                some.thickness.push_back(rods_.thickness[j]);
                some.chords.push_back(rods_.chords[j]);
                some.starts.push_back(rods_.starts[j]);
            }
            some.offsets.push_back(static_cast<std::uint32_t>(some.segmentLengths.size()));
        }
        return some;
    }

    void settleAnew(std::span<const std::uint32_t> which) {
        const Rods rods = rodsOf(which);
        const std::vector<float> shares = rootShares(part_.forces, picked(angles_, which));
        RodWorld world;
        world.gravity = style_.gravity;
        world.forces = part_.forces;
        world.rootShares = shares;
        world.solids = solids_;
        world.solidFrictions = frictions_;
        const std::vector<Layer> skins =
            skins_.empty() ? std::vector<Layer>() : picked(skins_, which);
        world.layers = skins;
        RestState state;
        RestOptions options;
        options.threads = threads_;
        std::vector<Vec3f> nodes(rods.nodeCount());
        const RestReport report = settleRods(rods, world, state, nodes, options);
        take(which, rods, nodes, report);
        const std::vector<Frame> frames = framesAtRest(rods, state);
        for (std::size_t k = 0; k < which.size(); ++k) {
            std::copy(frames.begin() + rods.offsets[k], frames.begin() + rods.offsets[k + 1],
                      rods_.starts.begin() + rods_.offsets[which[k]]);
        }
    }

    // What is to be seen of a strand: the groom's nodes up to there, and the end.
    void add(std::size_t i, Strands& out) const {
        const Strand& strand = strands_[i];
        const Place shown(strand.shown);
        const std::size_t firstRodNode = set_.rods.firstNode(i);
        const auto node = [&](std::size_t j) { return set_.nodes[j] - firstRodNode; };
        std::size_t j = groom_.offsets[i];
        for (; j < groom_.offsets[i + 1] && node(j) <= shown.node; ++j) {
            out.nodes.push_back(strand.nodes[node(j)].as<float>() + set_.offsets[j]);
            out.diameters.push_back(groom_.diameters[j]);
            out.colors.push_back(groom_.colors[j]);
            if (!groom_.transparency.empty()) out.transparency.push_back(groom_.transparency[j]);
        }
        if (shown.share > 0) {
            out.nodes.push_back(pointAt(strand, shown).as<float>());
            const auto mixed = [&](const auto& values) {
                return between(values[j - 1], values[j], shown.share);
            };
            out.diameters.push_back(mixed(groom_.diameters));
            out.colors.push_back(mixed(groom_.colors));
            if (!groom_.transparency.empty())
                out.transparency.push_back(mixed(groom_.transparency));
        }
        out.offsets.push_back(static_cast<std::uint32_t>(out.nodes.size()));
        out.keys.push_back(groom_.keys[i]);
    }

    const Style& style_;
    const Part& part_;
    const Strands& groom_;
    SetGroom set_;
    Rods rods_;  // with all that the style changes, and cut
    std::vector<Layer> skins_;
    const DistanceField* solids_;
    std::span<const float> frictions_;
    std::vector<EllipsoidAngles> angles_;
    std::vector<Strand> strands_;
    int threads_;
};

}  // namespace

Result<GroomPart> settleGroomPart(const Style& style, const Part& part, Strands groom,
                                  const DistanceField* solids, std::span<const float> frictions,
                                  int threads, const std::function<void(double)>& progress) {
    Stopwatch stopwatch;
    Result<OutsideGroom> set = setOutside(solids, groom, ordinary(part.hair), RodWorld{}, threads);
    if (!set) return set.problems();
    const double setTime = stopwatch.lap();
    const std::size_t pushedOut = set->pushedOut;
    PartAtRest rest(style, part, groom, std::move(*set), solids, frictions, threads);
    rest.settle(progress);
    for (const Cut& cut : part.cuts)
        rest.cut(cut);
    GroomPart settled = rest.finish();
    settled.setTime = setTime;
    settled.pushedOut = pushedOut;
    if (solids != nullptr) settled.stuck = pushOut(*solids, settled.strands, threads).stuck;
    return settled;
}

}  // namespace kushi
