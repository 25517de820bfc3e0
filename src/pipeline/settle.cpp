// SPDX-License-Identifier: Apache-2.0
#include "core/parallel.h"
#include "core/random.h"
#include "pipeline/hair_color.h"
#include "pipeline/penetration.h"
#include "pipeline/settle_part.h"
#include "pipeline/stopwatch.h"

#include <kushi/follicles.h>
#include <kushi/head.h>
#include <kushi/settle.h>

#include <algorithm>
#include <atomic>
#include <cmath>
#include <numeric>

namespace kushi {

namespace {

// Strands put together by one thread.
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

void appendDiameters(const Hair& hair, std::span<const Vec3f> nodes, std::vector<float>& out) {
    double walked = 0;
    for (std::size_t j = 0; j < nodes.size(); ++j) {
        if (j > 0) walked += length(nodes[j] - nodes[j - 1]);
        const double share = std::min(1.0, walked / hair.length);
        out.push_back(static_cast<float>(hair.diameter * (1 - hair.taper * share)));
    }
}

Block blockOf(const Part& part, const Follicles& follicles, const SettledPart& settled,
              std::size_t begin, std::size_t end, bool measurePenetration) {
    const Ellipsoid& ellipsoid = part.scalp.ellipsoid;
    Block block;
    for (std::size_t i = begin; i < end; ++i) {
        const std::span<const Vec3f> nodes = settled.strand(i);
        if (nodes.empty()) continue;
        const std::uint64_t key = follicles.keys[i];
        block.strands.add(nodes, key);
        appendHairColors(part.hair, key, nodes, block.strands.colors);
        appendDiameters(part.hair, nodes, block.strands.diameters);
        const Vec3d root = follicles.roots[i];
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
        const Part& part = style.parts[p];
        const Follicles& follicles = (*planted)[p];
        const Result<SettledPart> settled =
            settlePart(style, part, follicles, method, segments, options.threads);
        if (!settled) return settled.problems();
        groom.report.unsettled += settled->unsettled;
        if (method == Method::Equilibrium) {
            groom.report.maxResidual =
                std::max(groom.report.maxResidual.value_or(0), settled->maxResidual);
        }
        std::vector<Block> blocks((follicles.size() + blockSize - 1) / blockSize);
        parallelFor(
            follicles.size(), blockSize, options.threads, [&](std::size_t begin, std::size_t end) {
                blocks[begin / blockSize] =
                    blockOf(part, follicles, *settled, begin, end, options.measurePenetration);
                const std::size_t sofar = done += end - begin;
                if (options.progress) {
                    options.progress(static_cast<double>(sofar) / static_cast<double>(all));
                }
            });
        reserve(groom.strands, settled->nodes.size());
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
