// SPDX-License-Identifier: Apache-2.0
#include <kushi/shadows.h>

#include "core/parallel.h"
#include "shading/crossings.h"
#include "shading/depth_map.h"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <optional>

namespace kushi {

namespace {

constexpr int gridCells = 64;          // along the longest side of the hair
constexpr std::size_t skyLights = 16;  // that stand for light from everywhere
// Hair does not lie in its own shadow: it is looked for this share of a cube nearer to the light.
constexpr float ownHair = 0.4F;
constexpr float texel = 0.003F;        // of the head's maps for the lights [m]
constexpr float skyTexel = 0.006F;
constexpr float mostCrossings = 14;    // where nothing of the sky comes
constexpr float slack = 0.004F;        // by which skin may lie behind itself [m]
constexpr float skySlack = 0.008F;

/// Directions spread evenly over the sphere, along a spiral.
Vec3f skyDirection(std::size_t i) {
    const double height = 1 - (2 * static_cast<double>(i) + 1) / skyLights;
    const double angle = static_cast<double>(i) * std::numbers::pi * (3 - std::sqrt(5.0));
    const double around = std::sqrt(1 - height * height);
    return Vec3d{around * std::cos(angle), height, around * std::sin(angle)}.as<float>();
}

/// What comes from either side along each axis, of the half of all directions there.
struct SkyCube {
    std::array<Passage, 6> sides;  // +x, -x, +y, -y, +z, -z

    /// Between the sides by the squares of the direction's parts, which add up to 1.
    Passage from(Vec3f direction) const {
        const std::array<float, 3> parts = {direction.x, direction.y, direction.z};
        Passage sum = {0, 0};
        for (std::size_t i = 0; i < 3; ++i) {
            const Passage& side = sides[2 * i + (parts[i] < 0 ? 1 : 0)];
            sum.free += parts[i] * parts[i] * side.free;
            sum.crossings += parts[i] * parts[i] * side.crossings;
        }
        return sum;
    }
};

/// Sums over the directions of a side, weighted by how straight they come from it.
struct SideSum {
    float weights = 0, free = 0, through = 0;

    void add(float weight, float lit, float passing) {
        weights += weight;
        free += weight * lit;
        through += weight * lit * passing;
    }
    Passage passage() const {
        return {free / weights,
                through > 1e-6F ? std::min(std::log(free / through), mostCrossings)
                                : mostCrossings};
    }
};

}  // namespace

struct Shadows::Fields {
    struct OfLight {
        Vec3f towards;
        std::optional<DepthMap> head;
        std::vector<float> crossings;  // per cube
    };
    HairGrid grid;
    std::vector<OfLight> distant;
    std::vector<SkyCube> sky;  // per cube
};

Shadows::Shadows(const Strands& hair, const Mesh& head, const Lights& lights, int threads) {
    auto fields = std::make_unique<Fields>();
    fields->grid = hairGrid(hair, gridCells, threads);
    const HairGrid& grid = fields->grid;
    const std::size_t count = lights.distant.size();
    fields->distant.resize(count + skyLights);
    parallelFor(count + skyLights, 1, threads, [&](std::size_t begin, std::size_t end) {
        for (std::size_t i = begin; i < end; ++i) {
            const bool sky = i >= count;
            const Vec3f towards =
                sky ? skyDirection(i - count) : normalized(lights.distant[i].direction);
            fields->distant[i].towards = towards;
            fields->distant[i].crossings = crossingsTowards(grid, towards);
            fields->distant[i].head.emplace(head, towards, sky ? skyTexel : texel);
        }
    });

    fields->sky.resize(grid.cells.size());
    parallelFor(grid.cells.size(), 4096, threads, [&](std::size_t begin, std::size_t end) {
        for (std::size_t i = begin; i < end; ++i) {
            const Vec3f middle = grid.middle(i);
            std::array<SideSum, 6> sides;
            for (std::size_t j = 0; j < skyLights; ++j) {
                const Fields::OfLight& light = fields->distant[count + j];
                const Vec3f towards = skyDirection(j);
                const float lit = light.head->lit(middle, skySlack);
                const float passing = std::exp(-light.crossings[i]);
                const std::array<float, 3> parts = {towards.x, towards.y, towards.z};
                for (std::size_t k = 0; k < 3; ++k) {
                    sides[2 * k + (parts[k] < 0 ? 1 : 0)].add(std::abs(parts[k]), lit, passing);
                }
            }
            for (std::size_t k = 0; k < 6; ++k)
                fields->sky[i].sides[k] = sides[k].passage();
        }
    });
    fields->distant.resize(count);
    fields_ = std::move(fields);
}

Shadows::~Shadows() = default;
Shadows::Shadows(Shadows&&) noexcept = default;
Shadows& Shadows::operator=(Shadows&&) noexcept = default;

void Shadows::at(Vec3f place, std::span<Passage> distant) const {
    const Fields& fields = *fields_;
    for (std::size_t i = 0; i < distant.size(); ++i)
        distant[i] = {fields.distant[i].head->lit(place, slack), 0};
    if (fields.grid.empty()) return;
    for (std::size_t i = 0; i < distant.size(); ++i) {
        const Vec3f ahead = place + (ownHair * fields.grid.size) * fields.distant[i].towards;
        distant[i].crossings = sampleAt(fields.grid, ahead).of(fields.distant[i].crossings);
    }
}

Shadows::Sky Shadows::skyAt(Vec3f place, Vec3f side) const {
    const Fields& fields = *fields_;
    if (fields.grid.empty()) return {};
    Sky sky = {{0, 0}, {0, 0}};
    const auto add = [](Passage& sum, float weight, Passage one) {
        sum.free += weight * one.free;
        sum.crossings += weight * one.crossings;
    };
    const GridSample here = sampleAt(fields.grid, place + (ownHair * fields.grid.size) * side);
    const GridSample beyond = sampleAt(fields.grid, place);
    for (std::size_t i = 0; i < here.at.size(); ++i) {
        add(sky.here, here.weights[i], fields.sky[here.at[i]].from(side));
        add(sky.beyond, beyond.weights[i], fields.sky[beyond.at[i]].from(-side));
    }
    return sky;
}

}  // namespace kushi
