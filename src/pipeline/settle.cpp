// SPDX-License-Identifier: Apache-2.0
#include "core/parallel.h"
#include "pipeline/crowd.h"
#include "pipeline/dress.h"
#include "pipeline/groom_part.h"
#include "pipeline/groom_source.h"
#include "pipeline/hair_color.h"
#include "pipeline/penetration.h"
#include "pipeline/settle_part.h"
#include "pipeline/solids.h"
#include "pipeline/sources.h"
#include "pipeline/stopwatch.h"

#include <kushi/settle.h>

#include <algorithm>
#include <cmath>

namespace kushi {

namespace {

// Strands settled together by one thread.
constexpr std::size_t blockSize = 256;
// How far the drawn inner piece reaches from the follicle towards the ellipsoid's centre, and not
// past it [m].
constexpr double innerPiece = 0.02;

// The follicle itself where a groom stands so far off the ellipsoid that the piece would be seen.
Vec3f innerEnd(const Part& part, Vec3d root) {
    const Ellipsoid& ellipsoid = part.scalp.ellipsoid;
    const Vec3d inward = ellipsoid.center - root;
    const double away = length(inward);
    const double surface = away / std::sqrt(1 + ellipsoid.implicit(root));
    if (away == 0 || (part.groom && away - surface >= innerPiece)) return root.as<float>();
    return (root + std::min(1.0, innerPiece / away) * inward).as<float>();
}

constexpr int rounds = 3;    // of loosen()
constexpr float aim = 0.9F;  // of the packing asked for: what is led never comes quite there

// What a block of consecutive follicles has become.
struct Block {
    Strands strands;
    std::vector<Vec3f> innerEnds;
    Penetration found;
};

void appendDiameters(const Hair& hair, std::span<const Vec3f> nodes, std::vector<float>& out) {
    double walked = 0;
    for (std::size_t j = 0; j < nodes.size(); ++j) {
        if (j > 0) walked += length(nodes[j] - nodes[j - 1]);
        const double share = std::min(1.0, walked / hair.length);
        out.push_back(static_cast<float>(hair.diameter * (1 - hair.taper * share)));
    }
}

Block blockOf(const Part& part, const Follicles& follicles, const SettledPart& settled,
              std::size_t begin, std::size_t end, const Obstacles* measured) {
    Block block;
    for (std::size_t i = begin; i < end; ++i) {
        const std::span<const Vec3f> nodes = settled.strand(i);
        if (nodes.empty()) continue;
        const std::uint64_t key = follicles.keys[i];
        block.strands.add(nodes, key);
        appendHairColors(part, key, follicles.angles[i], nodes, block.strands.colors);
        appendDiameters(part.hair, nodes, block.strands.diameters);
        block.innerEnds.push_back(innerEnd(part, follicles.roots[i]));
        if (measured == nullptr) continue;
        include(deepestPoint(*measured, nodes), block.found);
    }
    return block;
}

template <class T>
void append(std::vector<T>& to, const std::vector<T>& from) {
    to.insert(to.end(), from.begin(), from.end());
}

void append(Strands& to, const Strands& from) {
    const auto base = static_cast<std::uint32_t>(to.nodes.size());
    for (std::size_t i = 1; i < from.offsets.size(); ++i)
        to.offsets.push_back(base + from.offsets[i]);
    append(to.nodes, from.nodes);
    append(to.keys, from.keys);
    append(to.diameters, from.diameters);
    append(to.colors, from.colors);
    // Only grooms have it; other hair is opaque.
    if (to.transparency.empty() && from.transparency.empty()) return;
    to.transparency.resize(base);
    append(to.transparency, from.transparency);
    to.transparency.resize(to.nodes.size());
}

// Room for so many more nodes.
void reserve(Strands& strands, std::size_t more) {
    const std::size_t nodes = strands.nodes.size() + more;
    strands.nodes.reserve(nodes);
    strands.diameters.reserve(nodes);
    strands.colors.reserve(nodes);
}

Status checkMethod(const Style& style, Method method) {
    if (method == Method::Equilibrium) return std::monostate{};
    for (const Part& part : style.parts) {
        if (part.groom || !part.ties.empty()) {
            return Problem{"the hair of '" + part.name + "' is " +
                           (part.groom ? "a groom" : "tied") +
                           ", which the cantilever method does not know; settle it by equilibrium "
                           "(--method equilibrium)"};
        }
        if (!part.hair.curl && !part.hair.wave && part.hair.taper == 0) continue;
        return Problem{"the hair of '" + part.name +
                       "' is curled, waved or tapered, which the cantilever method does not know; "
                       "settle it by equilibrium"};
    }
    return std::monostate{};
}

// The parts of a style, settled one after the other into one groom.
class Settling {
public:
    Settling(const Style& style, const SettleOptions& options, Method method,
             const DistanceField& solids, std::size_t all)
        : style_(style),
          options_(options),
          method_(method),
          solids_(solids.empty() ? nullptr : &solids),
          all_(static_cast<double>(all)),
          frictions_(frictionsOf(style)) {}

    Status add(const Part& part, const PartSource& source) {
        Status added = source.groom ? addGroom(part, source) : grow(part, source);
        done_ += source.size();
        show(static_cast<double>(done_));
        return added;
    }

    // Rounds in which hair that is too close is led apart, twice, and settles again.
    Status loosen() {
        if (!style_.contact.packing || method_ != Method::Equilibrium) return std::monostate{};
        const auto most = static_cast<float>(*style_.contact.packing);
        for (int round = 0; round < rounds && leadApart(most); ++round) {
            leadApart(most);
            for (GrownPart& grown : grown_) {
                if (Status settled = grown.hair.settleAgain(); !settled) return settled;
            }
        }
        return std::monostate{};
    }

    SettledGroom take(double solidsTime, double plantTime, double settleTime, double looseTime) {
        for (const Part& part : style_.parts) {
            for (GrownPart& grown : grown_)
                if (grown.part == &part) put(grown);
            for (GroomOfPart& groom : grooms_)
                if (groom.part == &part) put(groom);
        }
        SettleReport& report = groom_.report;
        if (solids_ != nullptr) {
            report.solidsSpacing = solids_->spacing;
            report.stages.push_back({"solids", solidsTime});
        }
        report.strands = groom_.strands.size();
        report.segments = groom_.strands.segmentCount();
        report.stages.push_back({"plant", plantTime});
        if (options_.measurePenetration) measureCrowding();
        if (holding_) {
            report.set = describe(*holding_);
            report.stages.push_back({"set", setTime_});
        }
        report.stages.push_back({"settle", settleTime - setTime_});
        if (style_.contact.packing) report.stages.push_back({"loosen", looseTime});
        if (dressTime_) report.stages.push_back({"dress", *dressTime_});
        return std::move(groom_);
    }

private:
    struct GrownPart {
        const Part* part;
        const PartSource* source;
        PartHair hair;
    };
    struct GroomOfPart {
        const Part* part;
        const PartSource* source;
        Strands strands;
    };

    Status grow(const Part& part, const PartSource& source) {
        PartSettling how;
        how.method = method_;
        how.segments = options_.segments.value_or(style_.solver.segments);
        how.solids = solids_;
        how.frictions = frictions_;
        how.again = style_.contact.packing && method_ == Method::Equilibrium;
        how.threads = options_.threads;
        how.layers = source.layers;
        grown_.push_back({&part, &source, PartHair(style_, part, source.follicles, how)});
        return grown_.back().hair.settle();
    }

    // Solids are what is seen; the ellipsoid stands for them where there are none.
    Obstacles obstaclesOf(const Part& part) const {
        const bool onEllipsoid = part.scalp.surface == ScalpSurface::Ellipsoid;
        return {solids_ == nullptr && onEllipsoid ? &part.scalp.ellipsoid : nullptr, solids_};
    }

    bool isInside(Vec3f place) const {
        if (solids_ != nullptr) return distanceAt(*solids_, place) < 0;
        return std::ranges::any_of(grown_, [&](const GrownPart& grown) {
            return kushi::isInside(obstaclesOf(*grown.part), place.as<double>());
        });
    }

    // Whether any hair is too close.
    bool leadApart(float most) {
        const std::vector<ThickStrand> strands = thickStrands();
        const Density density = densityOf(strands, voxelsFor(strands), options_.threads);
        if (density.largestPacking() <= most) return false;
        const auto inside = [this](Vec3f place) { return isInside(place); };
        const Spreading spreading(density, aim * most, inside);
        for (GrownPart& grown : grown_)
            grown.hair.lead(spreading);
        return true;
    }

    // Of a preview each is as thick as all that it stands for, so that it takes their space.
    std::vector<ThickStrand> thickStrands() const {
        std::vector<ThickStrand> all;
        for (const GrownPart& grown : grown_) {
            const double diameter = std::sqrt(grown.source->standsFor) * grown.part->hair.diameter;
            for (const auto nodes : grown.hair.strands())
                all.push_back({nodes, diameter});
        }
        for (const GroomOfPart& groom : grooms_)
            appendThick(groom.strands, groom.source->standsFor, all);
        return all;
    }

    void put(GrownPart& grown) {
        const Part& part = *grown.part;
        const Follicles& follicles = grown.source->follicles;
        SettledPart settled = grown.hair.take();
        groom_.report.pushedOut += settled.pushedOut;
        groom_.report.stuck += settled.stuck;
        const Obstacles obstacles = obstaclesOf(part);
        dress(grown, obstacles, settled);
        const Obstacles* measured = options_.measurePenetration ? &obstacles : nullptr;
        if (method_ == Method::Equilibrium) count(settled.maxResidual, settled.unsettled);
        std::vector<Block> blocks((follicles.size() + blockSize - 1) / blockSize);
        parallelFor(
            follicles.size(), blockSize, options_.threads, [&](std::size_t begin, std::size_t end) {
                blocks[begin / blockSize] = blockOf(part, follicles, settled, begin, end, measured);
            });
        reserve(groom_.strands, settled.nodes.size());
        PartPenetration penetration = {part.name, {}};
        for (const Block& block : blocks) {
            append(groom_.strands, block.strands);
            append(groom_.innerEnds, block.innerEnds);
            Penetration& found = penetration.found;
            found.deepest = std::max(found.deepest, block.found.deepest);
            found.strands += block.found.strands;
        }
        if (options_.measurePenetration) groom_.report.penetration.push_back(penetration);
    }

    void put(GroomOfPart& groom) {
        dress(groom);
        if (options_.measurePenetration && solids_ != nullptr) {
            groom_.report.penetration.push_back(
                {groom.part->name, penetrationOf(*solids_, groom.strands, options_.threads)});
        }
        append(groom_.strands, groom.strands);
        for (std::size_t i = 0; i < groom.strands.size(); ++i) {
            const Vec3d root = groom.strands.strand(i)[0].as<double>();
            groom_.innerEnds.push_back(innerEnd(*groom.part, root));
        }
    }

    Status addGroom(const Part& part, const PartSource& source) {
        const Strands& groom = *source.groom;
        const auto progress = [&](double share) {
            show(static_cast<double>(done_) + share * static_cast<double>(groom.size()));
        };
        Result<GroomPart> settled =
            settleGroomPart(style_, part, groom, solids_, frictions_, options_.threads, progress);
        if (!settled) return atSource(settled.problems()[0], *part.groom);
        count(settled->maxResidual, settled->unsettled);
        if (!holding_) holding_.emplace();
        append(holding_->factors, settled->holding.factors);
        holding_->unstable += settled->holding.unstable;
        holding_->unheld += settled->holding.unheld;
        setTime_ += settled->setTime;
        groom_.report.pushedOut += settled->pushedOut;
        groom_.report.stuck += settled->stuck;
        grooms_.push_back({&part, &source, std::move(settled->strands)});
        return std::monostate{};
    }

    void dress(const GrownPart& grown, const Obstacles& obstacles, SettledPart& settled) {
        if (!isDressed(grown.part->hair)) return;
        StrandsAtRest atRest = {{}, grown.source->follicles.keys};
        for (const auto [first, count] : settled.stretches)
            atRest.strands.push_back(std::span(settled.nodes).subspan(first, count));
        dress(*grown.part, *grown.source, obstacles, atRest);
    }

    void dress(GroomOfPart& groom) {
        if (!isDressed(groom.part->hair)) return;
        StrandsAtRest atRest = {{}, groom.strands.keys};
        for (std::size_t i = 0; i < groom.strands.size(); ++i)
            atRest.strands.push_back(groom.strands.strand(i));
        dress(*groom.part, *groom.source, {nullptr, solids_}, atRest);
    }

    void dress(const Part& part, const PartSource& source, const Obstacles& obstacles,
               const StrandsAtRest& atRest) {
        Stopwatch stopwatch;
        const DressReport report =
            kushi::dress(part.hair, source.clumps, part.scalp.ellipsoid.center, obstacles, atRest,
                         options_.threads);
        groom_.report.clumps += report.clumps;
        groom_.report.flyaways += report.flyaways;
        dressTime_ = dressTime_.value_or(0) + stopwatch.lap();
    }

    void measureCrowding() {
        std::vector<ThickStrand> all;
        appendThick(groom_.strands, 1, all);
        const Density density = densityOf(all, voxelsFor(all), options_.threads);
        groom_.report.crowding = {double{density.largestPacking()}, density.volume(1e-3F)};
    }

    void count(double residual, std::size_t unsettled) {
        groom_.report.maxResidual = std::max(groom_.report.maxResidual.value_or(0), residual);
        groom_.report.unsettled += unsettled;
    }

    void show(double done) const {
        if (options_.progress) options_.progress(done / all_);
    }

    const Style& style_;
    const SettleOptions& options_;
    Method method_;
    const DistanceField* solids_;
    double all_;
    std::size_t done_ = 0;
    double setTime_ = 0;
    std::optional<double> dressTime_;
    std::optional<Holding> holding_;
    std::vector<float> frictions_;  // of the solids
    std::vector<GrownPart> grown_;
    std::vector<GroomOfPart> grooms_;
    SettledGroom groom_;
};

}  // namespace

Result<SettledGroom> settle(const Style& style, const SettleOptions& options) {
    const Method method = options.method.value_or(style.solver.method);
    if (const Status known = checkMethod(style, method); !known) return known.problems();
    Stopwatch stopwatch;
    const Result<DistanceField> solids = solidsOf(style, options.cacheFolder, options.threads);
    if (!solids) return solids.problems();
    const double solidsTime = stopwatch.lap();
    const Result<std::vector<PartSource>> sources = sourcesOf(style, options.count, options.head);
    if (!sources) return sources.problems();
    const double plantTime = stopwatch.lap();

    std::size_t all = 0;
    for (const PartSource& source : *sources)
        all += source.size();
    Settling settling(style, options, method, *solids, all);
    for (std::size_t p = 0; p < style.parts.size(); ++p) {
        if (const Status added = settling.add(style.parts[p], (*sources)[p]); !added)
            return added.problems();
    }
    const double settleTime = stopwatch.lap();
    if (const Status loosened = settling.loosen(); !loosened) return loosened.problems();
    return settling.take(solidsTime, plantTime, settleTime, stopwatch.lap());
}

Strands withInnerPieces(const SettledGroom& groom) {
    Strands strands;
    std::vector<Vec3f> nodes;
    for (std::size_t i = 0; i < groom.strands.size(); ++i) {
        const auto visible = groom.strands.strand(i);
        const bool inner = groom.innerEnds[i] != visible[0];
        nodes.clear();
        if (inner) nodes.push_back(groom.innerEnds[i]);
        nodes.insert(nodes.end(), visible.begin(), visible.end());
        strands.add(nodes, groom.strands.keys[i]);

        const auto take = [&](const auto& from, auto& to) {
            const auto own = std::span(from).subspan(groom.strands.offsets[i], visible.size());
            if (inner) to.push_back(own[0]);
            to.insert(to.end(), own.begin(), own.end());
        };
        take(groom.strands.colors, strands.colors);
        take(groom.strands.diameters, strands.diameters);
    }
    return strands;
}

}  // namespace kushi
