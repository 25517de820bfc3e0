// SPDX-License-Identifier: Apache-2.0
#include "core/float4.h"
#include "core/parallel.h"
#include "geometry/axes.h"
#include "shading/crossings.h"
#include "shading/depth_map.h"

#include <kushi/shadows.h>

#include <algorithm>
#include <cmath>
#include <iterator>
#include <numbers>

namespace kushi {

namespace {

constexpr int gridCells = 64;          // along the longest side of the hair
constexpr float ownHair = 1;           // cubes: what is seen is the outermost of its own
constexpr float skinDeeper = 0.45F;    // cubes: skin lies beneath what hair is near it
constexpr std::size_t skyLights = 16;  // that stand for light from everywhere
constexpr float mostCrossings = 14;    // where nothing of the sky comes
constexpr float texel = 0.005F;        // of the head's maps for the lights [m]
constexpr float skyTexel = 0.006F;
constexpr float slack = 0.004F;     // by which skin may lie behind itself [m]
constexpr float penumbra = 0.008F;  // half of it, on skin [m]
constexpr float skySlack = 0.008F;

/// Directions spread evenly over the sphere, along a spiral.
Vec3f skyDirection(std::size_t i) {
    const double height = 1 - (2 * static_cast<double>(i) + 1) / skyLights;
    const double angle = static_cast<double>(i) * std::numbers::pi * (3 - std::sqrt(5.0));
    const double around = std::sqrt(1 - height * height);
    return Vec3d{around * std::cos(angle), height, around * std::sin(angle)}.as<float>();
}

/// Sums over the directions of a side, weighted by how straight they come from it.
struct SideSum {
    float weights = 0, free = 0, through = 0;

    void add(float weight, float lit, float passing) {
        weights += weight;
        free += weight * lit;
        through += weight * lit * passing;
    }
    Passage passage() const {
        const bool any = through > 1e-6F;
        return {free / weights,
                any ? std::min(std::log(free / through), mostCrossings) : mostCrossings};
    }
};

/// A light and what hides it.
struct FarLight {
    Vec3f towards;
    DepthMap head;
    std::vector<float> crossings;  // per cube
};

}  // namespace

/// Per cube some vectors of four:
///
///     free x, y, z of the sky's sides +x, +y, +z; the same of -x, -y, -z;
///     crossings of +x, +y, +z; of -x, -y, -z;
///     crossings towards the distant lights, four and four.
struct Shadows::Fields {
    static constexpr std::size_t ofSky = 4;

    HairGrid grid;
    std::vector<FarLight> distant, sky;
    std::size_t stride = ofSky;
    std::vector<Float4> cubes;
};

Shadows::Shadows(const Strands& hair, const Mesh& head, const Lights& lights, int threads) {
    auto fields = std::make_unique<Fields>();
    fields->grid = hairGrid(hair, gridCells, threads);
    const HairGrid& grid = fields->grid;
    const std::size_t count = lights.distant.size();
    std::vector<FarLight>& all = fields->distant;
    for (const Light& light : lights.distant)
        all.push_back({normalized(light.direction), {}, {}});
    for (std::size_t i = 0; i < skyLights; ++i)
        all.push_back({skyDirection(i), {}, {}});
    parallelFor(all.size(), 1, threads, [&](std::size_t begin, std::size_t end) {
        for (std::size_t i = begin; i < end; ++i) {
            FarLight& light = all[i];
            light.crossings = crossingsTowards(grid, light.towards, ownHair);
            light.head = DepthMap(head, light.towards, i < count ? texel : skyTexel);
        }
    });

    fields->stride = Fields::ofSky + (count + 3) / 4;
    fields->cubes.resize(grid.cells.size() * fields->stride);
    parallelFor(grid.cells.size(), 4096, threads, [&](std::size_t begin, std::size_t end) {
        for (std::size_t i = begin; i < end; ++i) {
            const Vec3f middle = grid.middle(i);
            std::array<std::array<SideSum, 3>, 2> sides;
            for (std::size_t j = count; j < all.size(); ++j) {
                const float lit = all[j].head.lit(middle, skySlack);
                const float passing = std::exp(-all[j].crossings[i]);
                const Vec3f towards = all[j].towards;
                const std::array<float, 3> parts = {towards.x, towards.y, towards.z};
                for (std::size_t k = 0; k < 3; ++k)
                    sides[parts[k] < 0 ? 1 : 0][k].add(std::abs(parts[k]), lit, passing);
            }
            Float4* const cube = &fields->cubes[i * fields->stride];
            for (std::size_t side = 0; side < 2; ++side) {
                for (std::size_t k = 0; k < 3; ++k) {
                    const Passage passage = sides[side][k].passage();
                    cube[side][k] = passage.free;
                    cube[2 + side][k] = passage.crossings;
                }
            }
            for (std::size_t j = 0; j < count; ++j)
                cube[Fields::ofSky + j / 4][j % 4] = all[j].crossings[i];
        }
    });
    fields->sky.assign(std::make_move_iterator(all.begin() + static_cast<std::ptrdiff_t>(count)),
                       std::make_move_iterator(all.end()));
    all.resize(count);
    for (FarLight& light : all)
        light.crossings = {};
    fields_ = std::move(fields);
}

Shadows::~Shadows() = default;
Shadows::Shadows(Shadows&&) noexcept = default;
Shadows& Shadows::operator=(Shadows&&) noexcept = default;

Shadows::Sky Shadows::at(Vec3f place, Vec3f side, std::span<Passage> distant) const {
    const Fields& fields = *fields_;
    for (std::size_t i = 0; i < distant.size(); ++i)
        distant[i] = {fields.distant[i].head.lit(place, slack), 0};
    if (fields.grid.empty()) return {};

    const GridPlace found = placeIn(fields.grid, place);
    const auto between = [&](std::size_t vector) {
        Float4 sum{};
        for (std::size_t i = 0; i < found.cubes.size(); ++i)
            sum += found.weights[i] * fields.cubes[found.cubes[i] * fields.stride + vector];
        return sum;
    };
    for (std::size_t i = 0; i < distant.size(); i += 4) {
        const Float4 crossings = between(Fields::ofSky + i / 4);
        for (std::size_t j = i; j < std::min(i + 4, distant.size()); ++j)
            distant[j].crossings = crossings[j - i];
    }
    // Between the sides by the squares of the direction's parts, which add up to 1.
    const Float4 parts = {side.x, side.y, side.z, 0};
    const Float4 shares = parts * parts;
    const auto sum = [&](Float4 values) {
        values *= shares;
        return values[0] + values[1] + values[2];
    };
    const Float4 freeAbove = between(0);
    const Float4 freeBelow = between(1);
    const Float4 above = between(2);
    const Float4 below = between(3);
    const Float4 none{};
    return {{sum(parts < none ? freeBelow : freeAbove), sum(parts < none ? below : above)},
            {sum(parts < none ? freeAbove : freeBelow), sum(parts < none ? above : below)}};
}

float Shadows::onSkin(Vec3f place, Vec3f normal, float blocked, std::span<float> distant) const {
    const Vec3f right = -penumbra * anyNormal(normal);
    const Vec3f up = cross(normal, right);
    const HairGrid& grid = fields_->grid;
    const Vec3f deeper = -skinDeeper * grid.size * normal;
    std::vector<Passage> passages(distant.size());
    std::vector<Passage> beneath(distant.size());
    std::ranges::fill(distant, 0.0F);
    for (const Vec3f from : {place, place + right, place - right, place + up, place - up}) {
        at(from, normal, passages);
        at(from + deeper, normal, beneath);
        for (std::size_t i = 0; i < distant.size(); ++i)
            distant[i] += 0.2F * passages[i].free * std::exp(-blocked * beneath[i].crossings);
    }

    const std::size_t cube = grid.empty() ? 0 : grid.cubeAt(place + deeper);
    float sum = 0;
    float weights = 0;
    for (const FarLight& light : fields_->sky) {
        const float facing = dot(normal, light.towards);
        if (facing <= 0) continue;
        weights += facing;
        const float crossings = grid.empty() ? 0 : light.crossings[cube];
        sum += facing * light.head.lit(place, skySlack) * std::exp(-blocked * crossings);
    }
    return weights > 0 ? sum / weights : 1;
}

std::vector<float> Shadows::crossingsBefore(std::span<const Vec3f> nodes, Vec3f eye,
                                            int threads) const {
    std::vector<float> before(nodes.size());
    const HairGrid& grid = fields_->grid;
    if (grid.empty()) return before;
    const Vec3f middle = 0.5F * (grid.middle(0) + grid.middle(grid.cells.size() - 1));
    const Vec3f way = eye - middle;
    if (!(length(way) > 0)) return before;
    // Tight hair has more than enough in its own cube, and the eye sees its surface.
    const Vec3f towards = normalized(way);
    const std::vector<float> crossings = crossingsTowards(grid, towards, 1);
    const Vec3f ahead = grid.size * towards;
    parallelFor(nodes.size(), 16384, threads, [&](std::size_t begin, std::size_t end) {
        for (std::size_t i = begin; i < end; ++i)
            before[i] = crossings[grid.cubeAt(nodes[i] + ahead)];
    });
    return before;
}

}  // namespace kushi
