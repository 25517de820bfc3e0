// SPDX-License-Identifier: Apache-2.0
#include "core/parallel.h"
#include "core/random.h"
#include "pipeline/hair_color.h"
#include "pipeline/penetration.h"
#include "pipeline/rest.h"
#include "pipeline/stopwatch.h"
#include "pipeline/strand.h"

#include <kushi/follicles.h>
#include <kushi/head.h>
#include <kushi/settle.h>

#include <algorithm>
#include <atomic>
#include <cmath>
#include <numeric>

namespace kushi {

namespace {

// Strands settled together by one thread.
constexpr std::size_t blockSize = 256;
// How far the drawn inner piece reaches from the follicle towards the ellipsoid's centre, and not
// past it [m].
constexpr double innerPiece = 0.02;

// What a block of consecutive follicles has become.
struct Block {
    Strands strands;
    std::vector<Vec3f> innerEnds;
    double deepest = 0;
};

std::uint64_t seedOf(const Style& style, const Part& part) {
    return mixKey(style.seed, textKey(part.name));
}

// `total` shared out in proportion to `weights`, rounded so that the shares add up to it.
std::vector<std::size_t> proportions(const std::vector<std::size_t>& weights, std::size_t total) {
    const auto sum =
        static_cast<double>(std::accumulate(weights.begin(), weights.end(), std::size_t{0}));
    std::vector<std::size_t> shares;
    double upTo = 0;
    std::size_t given = 0;
    for (const std::size_t weight : weights) {
        upTo += static_cast<double>(weight);
        const auto end =
            static_cast<std::size_t>(std::llround(upTo / sum * static_cast<double>(total)));
        shares.push_back(end - given);
        given = end;
    }
    return shares;
}

Result<Follicles> plantMore(const Part& part, std::uint64_t seed, std::size_t count) {
    Scalp scalp = part.scalp;
    scalp.spacing.reset();
    scalp.count = static_cast<int>(count);
    return plant(scalp, seed);
}

// The follicles of every part, in all as many as asked for.
Result<std::vector<Follicles>> plantAll(const Style& style, std::optional<std::size_t> count) {
    std::vector<Follicles> all;
    std::vector<std::size_t> sizes;
    for (const Part& part : style.parts) {
        Result<Follicles> planted = plant(part.scalp, seedOf(style, part));
        if (!planted) return planted.problems();
        sizes.push_back(planted->size());
        all.push_back(std::move(*planted));
    }
    const std::size_t own = std::accumulate(sizes.begin(), sizes.end(), std::size_t{0});
    if (!count || *count == own || own == 0) return all;

    const std::vector<std::size_t> shares = proportions(sizes, *count);
    for (std::size_t p = 0; p < all.size(); ++p) {
        if (shares[p] <= sizes[p]) {
            all[p] = thin(all[p], shares[p]);
            continue;
        }
        Result<Follicles> more =
            plantMore(style.parts[p], seedOf(style, style.parts[p]), shares[p]);
        if (!more) return more.problems();
        all[p] = std::move(*more);
    }
    return all;
}

// A part's strands as they are settled one by one, or all together before.
struct Shapes {
    const Style* style = nullptr;
    const Part* part = nullptr;
    const Follicles* follicles = nullptr;
    int segments = 0;
    std::optional<RestedPart> rested;

    // Overwrites `nodes`; none where the follicle has no hair.
    void nodesOf(std::size_t i, std::vector<Vec3f>& nodes) const {
        if (rested) {
            const auto all = std::span(rested->nodes);
            const std::size_t first = rested->offsets[i];
            const auto own = all.subspan(first, rested->offsets[i + 1] - first);
            nodes.assign(own.begin(), own.end());
            return;
        }
        nodes.clear();
        const StrandSite site = {follicles->roots[i], follicles->angles[i], follicles->keys[i]};
        for (const Vec3d node : settleStrand(*style, *part, site, segments))
            nodes.push_back(node.as<float>());
    }
};

void appendDiameters(const Hair& hair, std::span<const Vec3f> nodes, std::vector<float>& out) {
    double walked = 0;
    for (std::size_t j = 0; j < nodes.size(); ++j) {
        if (j > 0) walked += length(nodes[j] - nodes[j - 1]);
        const double share = std::min(1.0, walked / hair.length);
        out.push_back(static_cast<float>(hair.diameter * (1 - hair.taper * share)));
    }
}

Block settleBlock(const Shapes& shapes, std::size_t begin, std::size_t end,
                  bool measurePenetration) {
    const Ellipsoid& ellipsoid = shapes.part->scalp.ellipsoid;
    Block block;
    std::vector<Vec3f> nodes;
    for (std::size_t i = begin; i < end; ++i) {
        shapes.nodesOf(i, nodes);
        if (nodes.empty()) continue;
        const std::uint64_t key = shapes.follicles->keys[i];
        block.strands.add(nodes, key);
        appendHairColors(shapes.part->hair, key, nodes, block.strands.colors);
        appendDiameters(shapes.part->hair, nodes, block.strands.diameters);
        const Vec3d root = shapes.follicles->roots[i];
        const Vec3d inward = ellipsoid.center - root;
        const double reach = std::min(1.0, innerPiece / length(inward));
        block.innerEnds.push_back((root + reach * inward).as<float>());
        if (measurePenetration) {
            block.deepest = std::max(block.deepest, deepestPoint(ellipsoid, nodes));
        }
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
}

Status checkMethod(const Style& style, Method method) {
    if (method == Method::Equilibrium) return std::monostate{};
    for (const Part& part : style.parts) {
        if (!part.hair.curl && !part.hair.wave && part.hair.taper == 0) continue;
        return Problem{"the hair of '" + part.name +
                       "' is curled, waved or tapered, which the cantilever method does not know; "
                       "settle it by equilibrium"};
    }
    return std::monostate{};
}

}  // namespace

Result<SettledGroom> settle(const Style& style, const SettleOptions& options) {
    const Method method = options.method.value_or(style.solver.method);
    if (const Status known = checkMethod(style, method); !known) return known.problems();
    Stopwatch stopwatch;
    Result<std::vector<Follicles>> planted = plantAll(style, options.count);
    if (!planted) return planted.problems();
    const double plantTime = stopwatch.lap();

    const int segments = options.segments.value_or(style.solver.segments);
    std::size_t all = 0;
    for (const Follicles& follicles : *planted)
        all += follicles.size();

    SettledGroom groom;
    std::atomic<std::size_t> done{0};
    double deepest = 0;
    for (std::size_t p = 0; p < style.parts.size(); ++p) {
        const Follicles& follicles = (*planted)[p];
        Shapes shapes = {&style, &style.parts[p], &follicles, segments, {}};
        if (method == Method::Equilibrium) {
            Result<RestedPart> rested =
                restPart(style, style.parts[p], follicles, segments, options.threads);
            if (!rested) return rested.problems();
            groom.report.maxResidual =
                std::max(groom.report.maxResidual.value_or(0), rested->maxResidual);
            groom.report.unsettled += rested->unsettled;
            shapes.rested = std::move(*rested);
        }
        std::vector<Block> blocks((follicles.size() + blockSize - 1) / blockSize);
        parallelFor(follicles.size(), blockSize, options.threads,
                    [&](std::size_t begin, std::size_t end) {
                        blocks[begin / blockSize] =
                            settleBlock(shapes, begin, end, options.measurePenetration);
                        const std::size_t sofar = done += end - begin;
                        if (options.progress) {
                            options.progress(static_cast<double>(sofar) / static_cast<double>(all));
                        }
                    });
        for (const Block& block : blocks) {
            append(groom.strands, block.strands);
            append(groom.innerEnds, block.innerEnds);
            deepest = std::max(deepest, block.deepest);
        }
    }

    groom.report.strands = groom.strands.size();
    groom.report.segments = groom.strands.segmentCount();
    groom.report.stages = {{"plant", plantTime}, {"settle", stopwatch.lap()}};
    if (options.measurePenetration) groom.report.maxPenetration = deepest;
    return groom;
}

Result<Mesh> headOf(const Style& style) {
    if (style.headMesh == "none") return Mesh{};
    if (style.headMesh == "mannequin") return mannequin();
    return readMesh(style.headMesh, style.headPlacement);
}

Strands withInnerPieces(const SettledGroom& groom) {
    Strands strands;
    std::vector<Vec3f> nodes;
    for (std::size_t i = 0; i < groom.strands.size(); ++i) {
        const auto visible = groom.strands.strand(i);
        nodes.assign(1, groom.innerEnds[i]);
        nodes.insert(nodes.end(), visible.begin(), visible.end());
        strands.add(nodes, groom.strands.keys[i]);

        const auto colors =
            std::span(groom.strands.colors).subspan(groom.strands.offsets[i], visible.size());
        strands.colors.push_back(colors[0]);
        strands.colors.insert(strands.colors.end(), colors.begin(), colors.end());
    }
    return strands;
}

}  // namespace kushi
