// SPDX-License-Identifier: Apache-2.0
#include "pipeline/set_outside.h"

#include "contact/field_probe.h"
#include "core/parallel.h"
#include "pipeline/push_all_out.h"
#include "rod/strand_batch.h"

#include <kushi/push_out.h>

#include <algorithm>
#include <cmath>

namespace kushi {

namespace {

constexpr std::size_t together = 64;   // strands of one thread
constexpr double shortestStep = 2e-4;  // along a segment [m]
constexpr double apart = 2e-5;         // left between a strand and what is to push it [m]
constexpr float wholeAfter = 1e-4F;    // a strand's own skin counts from so far from its clamp [m]

bool isSound(const Strands& groom) {
    for (std::size_t i = 0; i < groom.size(); ++i)
        if (groom.strand(i).empty()) return false;
    return std::ranges::all_of(groom.nodes, [](Vec3f node) { return isFinite(node); });
}

// Where a strand comes out of solids: on its segment `node`, or at its end.
struct Exit {
    std::size_t node = 0;
    Vec3d place;
};

Exit exitOf(const DistanceField& solids, std::span<const Vec3f> nodes) {
    // Where pushOut() certainly brings it.
    const double out = 0.8 * marginOf(solids);
    for (std::size_t j = 0; j + 1 < nodes.size(); ++j) {
        const Vec3d from = nodes[j].as<double>();
        const Vec3d way = nodes[j + 1].as<double>() - from;
        const double size = length(way);
        // Distances grow by no more than the way.
        for (double along = 0; along < size;) {
            const Vec3d place = from + (along / size) * way;
            const double lack = out - double{distanceAt(solids, place.as<float>())};
            if (lack <= 0) return {j, place};
            along += std::max(shortestStep, lack);
        }
    }
    return {nodes.size() - 1, nodes.back().as<double>()};
}

// The least distance of a strand, as contact sees it; no more than the skin.
double nearest(const DistanceField& solids, Vec3d from, std::span<const Vec3f> nodes) {
    double least = contactSkin;
    for (const Vec3f node : nodes) {
        const Vec3d way = node.as<double>() - from;
        const double size = length(way);
        for (double along = 0; along < size;) {
            const double here = probe(solids, from + (along / size) * way).distance;
            least = std::min(least, here);
            along += std::max(shortestStep, here - least);
        }
        from = node.as<double>();
    }
    return std::min(least, probe(solids, from).distance);
}

// The strands from where they come out, with all that materials are made of.
Strands freed(const Strands& groom, std::span<const Exit> exits) {
    Strands free;
    for (std::size_t i = 0; i < groom.size(); ++i) {
        const std::size_t first = groom.offsets[i] + exits[i].node;
        std::vector<Vec3f> nodes = {exits[i].place.as<float>()};
        nodes.insert(nodes.end(), groom.nodes.begin() + static_cast<std::ptrdiff_t>(first) + 1,
                     groom.nodes.begin() + groom.offsets[i + 1]);
        free.add(nodes, groom.keys.empty() ? 0 : groom.keys[i]);
        for (std::size_t j = first; !groom.diameters.empty() && j < groom.offsets[i + 1]; ++j)
            free.diameters.push_back(groom.diameters[j]);
    }
    if (groom.keys.empty()) free.keys.clear();
    return free;
}

// The set of the freed strands as that of the whole ones.
void makeWhole(const Strands& groom, std::span<const Exit> exits, SetGroom& set) {
    std::vector<std::uint32_t> nodes;
    std::vector<Vec3f> offsets;
    std::size_t at = 0;  // of the freed strands' nodes
    for (std::size_t i = 0; i < groom.size(); ++i) {
        for (std::size_t j = groom.offsets[i]; j <= groom.offsets[i] + exits[i].node; ++j) {
            nodes.push_back(set.nodes[at]);
            offsets.push_back(groom.nodes[j] - set.rods.roots[i]);
        }
        ++at;
        for (std::size_t j = groom.offsets[i] + exits[i].node + 1; j < groom.offsets[i + 1]; ++j) {
            nodes.push_back(set.nodes[at]);
            offsets.push_back(set.offsets[at++]);
        }
    }
    set.nodes = std::move(nodes);
    set.offsets = std::move(offsets);
}

}  // namespace

Result<OutsideGroom> setOutside(const DistanceField* solids, Strands& groom, const Hair& hair,
                                const RodWorld& world, int threads) {
    SetOptions options;
    options.threads = threads;
    OutsideGroom outside;
    if (solids == nullptr || !isSound(groom)) {
        Result<SetGroom> set = restShapeOf(groom, materialsOf(groom, hair), world, options);
        if (!set) return set.problems();
        outside.set = std::move(*set);
        return outside;
    }
    outside.pushedOut = pushOut(*solids, groom, threads).pushed;
    std::vector<Exit> exits(groom.size());
    outside.skins.resize(groom.size());
    parallelFor(groom.size(), together, threads, [&](std::size_t begin, std::size_t end) {
        for (std::size_t i = begin; i < end; ++i) {
            const std::span<const Vec3f> nodes = groom.strand(i);
            exits[i] = exitOf(*solids, nodes);
            const double least =
                nearest(*solids, exits[i].place, nodes.subspan(exits[i].node + 1)) - apart;
            const double lower = std::clamp(contactSkin - least, 0.0, contactSkin);
            outside.skins[i] = {static_cast<float>(-lower) / wholeAfter, wholeAfter};
        }
    });
    const Strands free = freed(groom, exits);
    Result<SetGroom> set = restShapeOf(free, materialsOf(free, hair), world, options);
    if (!set) return set.problems();
    makeWhole(groom, exits, *set);
    outside.set = std::move(*set);
    return outside;
}

}  // namespace kushi
