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
constexpr float ownSkin = 0.55F;       // likewise of skin, which lies beneath hair and not in it
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

    Float4 between(const GridPlace& place, std::size_t vector) const {
        Float4 sum{};
        for (std::size_t i = 0; i < place.cubes.size(); ++i)
            sum += place.weights[i] * cubes[place.cubes[i] * stride + vector];
        return sum;
    }
    /// A place whose crossings towards a light are those of skin here.
    Vec3f beneath(Vec3f skin, Vec3f towards) const {
        return skin - (ownHair - ownSkin) * grid.size * towards;
    }
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
            Float4* const cube = &fields->cubes[i * fields->stride];
            for (std::size_t j = 0; j < count; ++j)
                cube[Fields::ofSky + j / 4][j % 4] = all[j].crossings[i];
            // Nodes lie in cubes with hair, as do those around them.
            if (grid.cells[i].density == 0) {
                cube[0] = cube[1] = float4(1);
                continue;
            }
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
            for (std::size_t side = 0; side < 2; ++side) {
                for (std::size_t k = 0; k < 3; ++k) {
                    const Passage passage = sides[side][k].passage();
                    cube[side][k] = passage.free;
                    cube[2 + side][k] = passage.crossings;
                }
            }
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
    const auto between = [&](std::size_t vector) { return fields.between(found, vector); };
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
    const Fields& fields = *fields_;
    const HairGrid& grid = fields.grid;
    for (std::size_t i = 0; i < distant.size(); ++i) {
        const FarLight& light = fields.distant[i];
        distant[i] = 0;
        for (const Vec3f from : {place, place + right, place - right, place + up, place - up}) {
            float crossings = 0;
            if (!grid.empty()) {
                const GridPlace found = placeIn(grid, fields.beneath(from, light.towards));
                crossings = fields.between(found, Fields::ofSky + i / 4)[i % 4];
            }
            distant[i] += 0.2F * light.head.lit(from, slack) * std::exp(-blocked * crossings);
        }
    }

    float sum = 0;
    float weights = 0;
    for (const FarLight& light : fields.sky) {
        const float facing = dot(normal, light.towards);
        if (facing <= 0) continue;
        weights += facing;
        const float crossings =
            grid.empty() ? 0 : light.crossings[grid.cubeAt(fields.beneath(place, light.towards))];
        sum += facing * light.head.lit(place, skySlack) * std::exp(-blocked * crossings);
    }
    return weights > 0 ? sum / weights : 1;
}

}  // namespace kushi
