// SPDX-License-Identifier: Apache-2.0
#include "pipeline/sources.h"

#include "core/random.h"
#include "pipeline/groom_source.h"
#include "pipeline/spread.h"

#include <kushi/settle.h>

#include <algorithm>
#include <cmath>
#include <numeric>

namespace kushi {

namespace {

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

// Of hair that lies on hair, unless the style says otherwise: share of the space that it fills.
constexpr double lyingPacking = 0.15;

std::vector<Vec3d> rootsOf(const Strands& groom) {
    std::vector<Vec3d> roots;
    for (std::size_t i = 0; i < groom.size(); ++i)
        roots.push_back(groom.strand(i)[0].as<double>());
    return roots;
}

ClumpCentres clumpsOf(const Part& part, std::span<const Vec3d> roots,
                      std::span<const std::uint64_t> keys) {
    const Clump& clump = part.hair.clump;
    return clump.amount > 0 ? ClumpCentres(roots, keys, clump.size) : ClumpCentres();
}

Result<PartSource> sourceOf(const Part& part, const Contact& contact, std::uint64_t seed,
                            const Mesh& head) {
    if (part.groom) {
        Result<Strands> groom = groomOf(part);
        if (!groom) return groom.problems();
        complete(*groom, part, seed);
        PartSource source = {{}, std::move(*groom)};
        source.clumps = clumpsOf(part, rootsOf(*source.groom), source.groom->keys);
        return source;
    }
    Result<Follicles> planted = plant(part.scalp, seed, head);
    if (!planted) return planted.problems();
    PartSource source = {std::move(*planted), {}};
    source.clumps = clumpsOf(part, source.follicles.roots, source.follicles.keys);
    if (contact.layers) {
        source.layers = layerMapOf(part.scalp.ellipsoid, source.follicles, part.hair.diameter,
                                   contact.packing.value_or(lyingPacking));
    }
    return source;
}

bool growsFromHead(const Style& style) {
    return std::ranges::any_of(style.parts, [](const Part& part) {
        return !part.groom && part.scalp.surface == ScalpSurface::Head;
    });
}

Strands thinned(const Strands& groom, std::size_t count) {
    std::vector<Vec3f> roots;
    for (std::size_t i = 0; i < groom.size(); ++i)
        roots.push_back(groom.strand(i)[0]);
    return subset(groom, spreadSubset(roots, count));
}

// With another number of strands.
Result<PartSource> resized(PartSource source, const Part& part, const Contact& contact,
                           std::uint64_t seed, const Mesh& head, std::size_t count) {
    if (count > 0 && count < source.size())
        source.standsFor = static_cast<double>(source.size()) / static_cast<double>(count);
    if (source.groom) {
        source.groom = thinned(*source.groom, count);
        return source;
    }
    if (count <= source.size()) {
        source.follicles = thin(source.follicles, count);
        return source;
    }
    Part more = part;
    more.scalp.spacing.reset();
    more.scalp.count = static_cast<int>(count);
    return sourceOf(more, contact, seed, head);
}

}  // namespace

Result<std::vector<PartSource>> sourcesOf(const Style& style, std::optional<std::size_t> count,
                                          const Mesh* head) {
    if (head == nullptr) {
        const Result<Mesh> read = growsFromHead(style) ? headOf(style) : Mesh{};
        if (!read) return read.problems();
        return sourcesOf(style, count, &*read);
    }
    std::vector<PartSource> all;
    std::vector<std::size_t> sizes;
    for (const Part& part : style.parts) {
        Result<PartSource> source = sourceOf(part, style.contact, seedOf(style, part), *head);
        if (!source) return source.problems();
        sizes.push_back(source->size());
        all.push_back(std::move(*source));
    }
    const std::size_t own = std::accumulate(sizes.begin(), sizes.end(), std::size_t{0});
    if (!count || *count == own || own == 0) return all;

    const std::vector<std::size_t> shares = proportions(sizes, *count);
    for (std::size_t p = 0; p < all.size(); ++p) {
        const Part& part = style.parts[p];
        Result<PartSource> source =
            resized(std::move(all[p]), part, style.contact, seedOf(style, part), *head, shares[p]);
        if (!source) return source.problems();
        all[p] = std::move(*source);
    }
    return all;
}

}  // namespace kushi
