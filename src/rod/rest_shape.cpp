// SPDX-License-Identifier: Apache-2.0
#include "core/parallel.h"
#include "core/random.h"
#include "rod/inverse_statics.h"

#include <kushi/rest_shape.h>

#include <algorithm>
#include <cmath>
#include <string>

namespace kushi {

namespace {

// Nodes go together below this share of the strand's mean segment.
constexpr double nearness = 1e-3;
// Strands that a thread takes at once.
constexpr std::size_t grain = 64;

Status checkGroom(const Strands& groom, const StrandMaterials& materials) {
    for (std::size_t i = 0; i < groom.size(); ++i) {
        if (groom.strand(i).empty())
            return Problem{"strand " + std::to_string(i) + " has no node; leave it out"};
        for (const Vec3f node : groom.strand(i)) {
            if (isFinite(node)) continue;
            return Problem{"strand " + std::to_string(i) + " has a node that is not finite"};
        }
    }
    const std::size_t size = groom.size();
    const auto positive = [](float x) { return x > 0 && std::isfinite(x); };
    if (materials.bending.size() != size || materials.twisting.size() != size ||
        materials.weights.size() != size ||
        (!materials.thickness.empty() && materials.thickness.size() != groom.nodes.size())) {
        return Problem{"the materials are not of as many strands as the groom has"};
    }
    for (std::size_t i = 0; i < size; ++i) {
        if (positive(materials.bending[i]) && positive(materials.twisting[i]) &&
            materials.weights[i] >= 0 && std::isfinite(materials.weights[i]))
            continue;
        return Problem{"strand " + std::to_string(i) +
                       " has a stiffness that is not above 0, or a weight below 0"};
    }
    if (!std::all_of(materials.thickness.begin(), materials.thickness.end(), positive))
        return Problem{"there is a thickness that is not above 0"};
    return std::monostate{};
}

// Which nodes of a strand are nodes of its rod; root first.
std::vector<std::uint32_t> distinctNodes(std::span<const Vec3f> nodes) {
    std::vector<std::uint32_t> kept = {0};
    const double least =
        nearness * polylineLength(nodes) / static_cast<double>(std::max(nodes.size(), 2UL) - 1);
    for (std::uint32_t i = 1; i < nodes.size(); ++i) {
        const double gap = length(nodes[i].as<double>() - nodes[kept.back()].as<double>());
        if (gap > least) kept.push_back(i);
    }
    return kept;
}

// Takes the nodes of every strand in turn.
void addStrand(SetGroom& set, std::span<const Vec3f> nodes, std::vector<std::uint32_t>& kept) {
    const std::size_t first = set.rods.nodeCount();
    const auto base = static_cast<std::uint32_t>(kept.size());
    const std::vector<std::uint32_t> distinct = distinctNodes(nodes);
    std::size_t at = 0;
    for (std::uint32_t i = 0; i < nodes.size(); ++i) {
        if (at + 1 < distinct.size() && distinct[at + 1] == i) ++at;
        set.nodes.push_back(static_cast<std::uint32_t>(first + at));
        set.offsets.push_back(nodes[i] - nodes[distinct[at]]);
    }
    kept.insert(kept.end(), distinct.begin(), distinct.end());
    set.rods.offsets.push_back(set.rods.offsets.back() +
                               static_cast<std::uint32_t>(kept.size() - base - 1));
    set.rods.roots.push_back(nodes[0]);
}

// The strand as a rod of segments that are as long and lie as in the groom; its frames.
std::vector<Rotation> shape(Rods& rods, std::uint32_t strand, std::span<const Vec3d> nodes) {
    std::vector<Rotation> frames = framesAlong(nodeTangents(nodes));
    rods.clamps[strand] = frameOf(frames[0]);
    double total = 0;
    for (std::size_t j = 1; j < nodes.size(); ++j) {
        const std::size_t segment = rods.offsets[strand] + j - 1;
        const Vec3d chord = nodes[j] - nodes[j - 1];
        total += length(chord);
        rods.segmentLengths[segment] = static_cast<float>(length(chord));
        rods.chords[segment] =
            rotate(inverse(halfway(frames[j - 1], frames[j])), chord).as<float>();
        rods.starts[segment] = frameOf(frames[j]);
    }
    rods.lengths[strand] = static_cast<float>(total);
    return frames;
}

void makeRoom(Rods& rods, const StrandMaterials& materials) {
    const std::size_t segments = rods.offsets.back();
    rods.clamps.resize(rods.size());
    rods.lengths.resize(rods.size());
    rods.bending = materials.bending;
    rods.twisting = materials.twisting;
    rods.weights = materials.weights;
    rods.segmentLengths.resize(segments);
    rods.naturalCurvature.resize(segments);
    rods.chords.resize(segments);
    rods.starts.resize(segments);
    if (!materials.thickness.empty()) rods.thickness.resize(segments);
}

// The set of one strand.
Hold setStrand(Rods& rods, const RodWorld& world, std::uint32_t strand,
               std::span<const Vec3d> nodes, std::span<const float> thickness, bool stiffen) {
    if (nodes.size() < 2) return {};
    for (std::size_t j = 1; j < thickness.size(); ++j) {
        rods.thickness[rods.offsets[strand] + j - 1] =
            0.5F * (thickness[j - 1] + thickness[j]) / thickness[0];
    }
    const std::vector<Rotation> frames = shape(rods, strand, nodes);
    return balance(rods, world, strand, frames, stiffen);
}

}  // namespace

StrandMaterials materialsOf(const Strands& groom, const Hair& hair) {
    StrandMaterials materials;
    if (!groom.diameters.empty()) materials.thickness.assign(groom.nodes.size(), 1);
    for (std::size_t i = 0; i < groom.size(); ++i) {
        double area = 1;  // of the root, over that of `hair`
        if (!groom.diameters.empty()) {
            const std::size_t count = groom.offsets[i + 1] - groom.offsets[i];
            const auto own = std::span(groom.diameters).subspan(groom.offsets[i], count);
            const float largest = *std::max_element(own.begin(), own.end());
            if (largest > 0 && std::isfinite(largest)) {
                const float root = std::max(own[0], 0.1F * largest);
                for (std::size_t j = 0; j < count; ++j) {
                    materials.thickness[groom.offsets[i] + j] =
                        std::max(own[j], 0.1F * largest) / root;
                }
                area = (root / hair.diameter) * (root / hair.diameter);
            }
        }
        const double bending = hair.rigidity() * area * area;
        materials.bending.push_back(static_cast<float>(bending));
        materials.twisting.push_back(static_cast<float>(hair.torsionalRigidity() * area * area));
        materials.weights.push_back(static_cast<float>(hair.weightPerLength() * area));
    }
    return materials;
}

Result<SetGroom> restShapeOf(const Strands& groom, const StrandMaterials& materials,
                             const RodWorld& world, const SetOptions& options) {
    if (const Status sound = checkGroom(groom, materials); !sound) return sound.problems();
    SetGroom set;
    std::vector<std::uint32_t> kept;
    for (std::uint32_t i = 0; i < groom.size(); ++i) {
        addStrand(set, groom.strand(i), kept);
        set.rods.keys.push_back(groom.keys.empty() ? scramble(i) : groom.keys[i]);
    }
    makeRoom(set.rods, materials);

    RodWorld loads = world;
    loads.obstacle = nullptr;
    std::vector<Hold> holds(groom.size());
    parallelFor(groom.size(), grain, options.threads, [&](std::size_t begin, std::size_t end) {
        std::vector<Vec3d> nodes;
        std::vector<float> thickness;
        for (std::size_t i = begin; i < end; ++i) {
            const std::size_t first = set.rods.firstNode(i);
            nodes.clear();
            thickness.clear();
            for (std::size_t j = first; j <= first + set.rods.segments(i); ++j) {
                nodes.push_back(groom.strand(i)[kept[j]].as<double>());
                if (!materials.thickness.empty())
                    thickness.push_back(materials.thickness[groom.offsets[i] + kept[j]]);
            }
            holds[i] = setStrand(set.rods, loads, static_cast<std::uint32_t>(i), nodes, thickness,
                                 options.stiffen);
        }
    });
    for (std::uint32_t i = 0; i < groom.size(); ++i) {
        set.factors.push_back(static_cast<float>(holds[i].factor));
        if (!holds[i].stable) set.unstable.push_back(i);
        if (!std::isfinite(holds[i].factor)) set.unheld.push_back(i);
    }
    return set;
}

Rods withStrength(const Rods& set, double strength) {
    Rods rods = set;
    if (strength == 1) return rods;
    const auto share = static_cast<float>(strength);
    for (Vec3f& curvature : rods.naturalCurvature)
        curvature *= share;
    for (Vec3f& chord : rods.chords) {
        const Vec3d own = chord.as<double>();
        const double d = length(own);
        const Vec3d mixed = strength * own + (1 - strength) * d * Vec3d{0, 0, 1};
        // One that runs back along the frame has no way round.
        if (length(mixed) > 1e-6 * d) chord = (d * normalized(mixed)).as<float>();
    }
    return rods;
}

void placeNodes(const SetGroom& set, std::span<const Vec3f> rodNodes, std::span<Vec3f> nodes) {
    for (std::size_t i = 0; i < nodes.size(); ++i)
        nodes[i] = rodNodes[set.nodes[i]] + set.offsets[i];
}

}  // namespace kushi
