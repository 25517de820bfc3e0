// SPDX-License-Identifier: Apache-2.0
#include "shading/hair_grid.h"

#include "core/parallel.h"

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <mutex>
#include <numbers>
#include <span>

namespace kushi {

namespace {

constexpr float smallest = 0.003F;  // edge of a cube [m]
constexpr float perFace = 65536;    // units of area in the face of a cube
constexpr std::size_t strandsAtATime = 2048;

/// Fibre area in units, and the same times the direction.
struct Sum {
    std::int64_t x = 0, y = 0, z = 0, area = 0;

    Sum& operator+=(const Sum& other) {
        x += other.x;
        y += other.y;
        z += other.z;
        area += other.area;
        return *this;
    }
};

std::int64_t rounded(float value) {
    constexpr float most = 0x1p40F;
    return std::llrint(std::clamp(value, -most, most));
}

class Splat {
public:
    explicit Splat(const HairGrid& grid)
        : grid_(grid), sums_(grid.cells.size()), unit_(perFace / (grid.size * grid.size)) {}

    void add(std::span<const Vec3f> nodes, std::span<const float> diameters) {
        for (std::size_t i = 0; i + 1 < nodes.size(); ++i) {
            const Vec3f step = nodes[i + 1] - nodes[i];
            const float size = length(step);
            if (!(size > 0) || !std::isfinite(size)) continue;
            const float diameter = usable(
                diameters.empty() ? usualDiameter : 0.5F * (diameters[i] + diameters[i + 1]));
            const int pieces = std::min(1 + static_cast<int>(size / grid_.size), 1024);
            const float area = diameter * size * unit_ / static_cast<float>(pieces);
            const float along = area / size;
            const Sum sum = {rounded(step.x * along), rounded(step.y * along),
                             rounded(step.z * along), rounded(area)};
            for (int piece = 0; piece < pieces; ++piece) {
                const float share = (static_cast<float>(piece) + 0.5F) / static_cast<float>(pieces);
                sums_[grid_.cubeAt(nodes[i] + share * step)] += sum;
            }
        }
    }

    const std::vector<Sum>& sums() const { return sums_; }

private:
    /// No thicker than a cube; 0 for what is no diameter.
    float usable(float diameter) const { return diameter > 0 ? std::min(diameter, grid_.size) : 0; }

    const HairGrid& grid_;
    std::vector<Sum> sums_;
    float unit_;
};

Bounds finiteBounds(std::span<const Vec3f> nodes) {
    Bounds bounds;
    for (const Vec3f node : nodes) {
        if (isFinite(node)) bounds.include(node);
    }
    return bounds;
}

/// Along one axis each cube shares half of what it has with its two neighbours, so that which cube
/// a piece fell into matters less.
void blur(std::vector<Sum>& sums, const HairGrid& grid, std::size_t axis) {
    const std::size_t stride = grid.strides()[axis];
    const auto count = static_cast<std::size_t>(grid.counts[axis]);
    for (std::size_t i = 0; i < sums.size(); ++i) {
        if (i / stride % count != 0) continue;
        Sum before;
        for (std::size_t j = 0; j < count; ++j) {
            Sum& sum = sums[i + j * stride];
            const Sum here = sum;
            const Sum after = j + 1 < count ? sums[i + (j + 1) * stride] : Sum();
            sum = {(before.x + 2 * here.x + after.x) / 4, (before.y + 2 * here.y + after.y) / 4,
                   (before.z + 2 * here.z + after.z) / 4,
                   (before.area + 2 * here.area + after.area) / 4};
            before = here;
        }
    }
}

}  // namespace

float HairGrid::Cell::crossings(Vec3f direction) const {
    // The mean sine of an angle between two directions.
    constexpr float anyWay = std::numbers::pi_v<float> / 4;
    const float agreement = length(way);
    const float along = dot(way, direction);
    const float across = std::sqrt(std::max(0.0F, agreement * agreement - along * along));
    return density * (across + (1 - agreement) * anyWay);
}

Vec3f HairGrid::middle(std::size_t cell) const {
    const auto columns = static_cast<std::size_t>(counts[0]);
    const auto rows = static_cast<std::size_t>(counts[1]);
    const std::size_t x = cell % columns;
    const std::size_t y = cell / columns % rows;
    const std::size_t z = cell / columns / rows;
    return low + size * Vec3f{static_cast<float>(x) + 0.5F, static_cast<float>(y) + 0.5F,
                              static_cast<float>(z) + 0.5F};
}

std::size_t HairGrid::cubeAt(Vec3f place) const {
    const Vec3f at = (place - low) / size;
    // Written so that what is not a number lies in the first cube.
    const auto along = [](float x, int count) {
        return x > 0 ? static_cast<int>(std::min(x, static_cast<float>(count - 1))) : 0;
    };
    return index(along(at.x, counts[0]), along(at.y, counts[1]), along(at.z, counts[2]));
}

HairGrid hairGrid(const Strands& strands, int cells, int threads) {
    HairGrid grid;
    const Bounds bounds = finiteBounds(strands.nodes);
    if (bounds.empty()) return grid;
    const Vec3f extent = bounds.high - bounds.low;
    const float longest = std::max({extent.x, extent.y, extent.z});
    grid.size = std::max(smallest, longest / static_cast<float>(cells));
    // Hair thins out over a cube of margin; in the outermost there is none, rounded as it may be.
    grid.low = bounds.low - 2.001F * grid.size * Vec3f{1, 1, 1};
    const auto along = [&](float size) { return 6 + static_cast<int>(size / grid.size); };
    grid.counts = {along(extent.x), along(extent.y), along(extent.z)};
    grid.cells.resize(grid.index(0, 0, grid.counts[2]));

    std::vector<Sum> sums(grid.cells.size());
    std::mutex merging;
    const std::size_t grain = std::max(strandsAtATime, (strands.size() + 3) / 4);
    parallelFor(strands.size(), grain, threads, [&](std::size_t begin, std::size_t end) {
        Splat splat(grid);
        for (std::size_t i = begin; i < end; ++i) {
            const std::span<const Vec3f> nodes = strands.strand(i);
            const auto diameters =
                strands.diameters.empty()
                    ? std::span<const float>()
                    : std::span(strands.diameters).subspan(strands.offsets[i], nodes.size());
            splat.add(nodes, diameters);
        }
        const std::scoped_lock lock(merging);
        for (std::size_t i = 0; i < sums.size(); ++i)
            sums[i] += splat.sums()[i];
    });
    for (std::size_t axis = 0; axis < 3; ++axis)
        blur(sums, grid, axis);
    const float scale = 1 / (perFace * grid.size);
    for (std::size_t i = 0; i < sums.size(); ++i) {
        const auto& [x, y, z, area] = sums[i];
        if (area <= 0) continue;
        const float inverse = 1 / static_cast<float>(area);
        grid.cells[i] = {
            Vec3f{static_cast<float>(x), static_cast<float>(y), static_cast<float>(z)} * inverse,
            static_cast<float>(area) * scale};
    }
    return grid;
}

GridPlace placeIn(const HairGrid& grid, Vec3f place) {
    const Vec3f at = (place - grid.low) / grid.size;
    std::array<std::size_t, 3> first{};
    std::array<float, 3> share{};
    const std::array<float, 3> places = {at.x - 0.5F, at.y - 0.5F, at.z - 0.5F};
    for (std::size_t i = 0; i < 3; ++i) {
        // Written so that what is not a number lies in the first cube.
        const auto last = static_cast<float>(grid.counts[i] - 1);
        const float inside = places[i] > 0 ? std::min(places[i], last) : 0;
        first[i] = std::min(static_cast<std::size_t>(inside),
                            static_cast<std::size_t>(grid.counts[i] - 2));
        share[i] = inside - static_cast<float>(first[i]);
    }
    const auto [strideX, strideY, strideZ] = grid.strides();
    const std::size_t base = first[0] * strideX + first[1] * strideY + first[2] * strideZ;
    GridPlace found{};
    for (std::size_t i = 0; i < 8; ++i) {
        const std::size_t x = i >> 2U;
        const std::size_t y = (i >> 1U) & 1U;
        const std::size_t z = i & 1U;
        found.cubes[i] = base + x * strideX + y * strideY + z * strideZ;
        found.weights[i] = (x != 0 ? share[0] : 1 - share[0]) * (y != 0 ? share[1] : 1 - share[1]) *
                           (z != 0 ? share[2] : 1 - share[2]);
    }
    return found;
}

}  // namespace kushi
