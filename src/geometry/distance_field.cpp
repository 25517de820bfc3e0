// SPDX-License-Identifier: Apache-2.0
#include "geometry/field_grid.h"
#include "geometry/field_solid.h"

#include <kushi/distance_field.h>

#include <algorithm>
#include <cmath>
#include <limits>

namespace kushi {

Result<DistanceField> distanceFieldOf(std::span<const Solid> solids,
                                      const DistanceFieldOptions& options) {
    Result<DistanceField> grid = gridFor(solids, options);
    if (!grid || grid->spacing == 0) return grid;
    DistanceField field = std::move(grid).value();
    const std::size_t samples = field.index(0, 0, field.size[2]);
    field.units.assign(samples, std::numeric_limits<std::int16_t>::max());
    if (solids.size() > 1) field.nearest.assign(samples, 0);
    for (std::size_t i = 0; i < solids.size(); ++i)
        addSolid(field, solids[i], static_cast<std::uint8_t>(i), options.threads);
    return field;
}

namespace {

// std::lerp is careful where this need not be, and takes several times as long.
float mix(float a, float b, float share) {
    return a + share * (b - a);
}

}  // namespace

float distanceAt(const DistanceField& field, Vec3f place) {
    if (field.empty()) return 1;
    struct Cell {
        int first;
        float part;  ///< of the way to the next sample
    };
    const auto cellOf = [&field](float way, std::size_t k) {
        // In this order, what is no number becomes 0.
        const auto last = static_cast<float>(field.size[k] - 1);
        const float at = std::min(std::max(0.0F, way / field.spacing), last);
        const int first = std::min(static_cast<int>(at), field.size[k] - 2);
        return Cell{first, at - static_cast<float>(first)};
    };
    const Vec3f way = place - field.origin;
    const Cell x = cellOf(way.x, 0), y = cellOf(way.y, 1), z = cellOf(way.z, 2);
    const auto along = [&](int j, int k) {
        const std::size_t i = field.index(x.first, y.first + j, z.first + k);
        return mix(static_cast<float>(field.units[i]), static_cast<float>(field.units[i + 1]),
                   x.part);
    };
    const float units =
        mix(mix(along(0, 0), along(1, 0), y.part), mix(along(0, 1), along(1, 1), y.part), z.part);
    const auto end = [&field](std::size_t k) {
        return field.spacing * static_cast<float>(field.size[k] - 1);
    };
    const Vec3f beyond = {way.x - std::clamp(way.x, 0.0F, end(0)),
                          way.y - std::clamp(way.y, 0.0F, end(1)),
                          way.z - std::clamp(way.z, 0.0F, end(2))};
    return units * field.unit() + length(beyond);
}

}  // namespace kushi
