// SPDX-License-Identifier: Apache-2.0
#include "core/parallel.h"
#include "core/smooth_step.h"

#include <kushi/shade.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <numbers>

namespace kushi {

namespace {

constexpr float reach = 0.008F;        // how far from a root the skin takes its colour [m]
constexpr double thick = 8e4;          // roots per m2 from which skin is wholly tinted
constexpr float depth = 0.6F;          // skin between roots, to the hair's own colour
constexpr double mostBelow = 0.03;     // skin farther than this from the scalp stays skin [m]
constexpr std::size_t samples = 1000;  // of roots, for the density that is usual

struct Root {
    std::uint64_t cell = 0;
    Vec3f place;
    Rgb color;
};

std::int64_t cellAlong(float x) {
    return static_cast<std::int64_t>(std::floor(x / reach));
}

std::uint64_t cellKey(std::int64_t x, std::int64_t y, std::int64_t z) {
    constexpr std::int64_t middle = 1 << 20;
    const auto part = [](std::int64_t i) {
        return static_cast<std::uint64_t>(std::clamp<std::int64_t>(i + middle, 0, 2 * middle - 1));
    };
    return part(x) << 42U | part(y) << 21U | part(z);
}

std::uint64_t cellOf(Vec3f p) {
    return cellKey(cellAlong(p.x), cellAlong(p.y), cellAlong(p.z));
}

/// What grows about a place.
struct Growth {
    double density = 0;  ///< roots per m2
    Rgb color;           ///< their mean
};

/// The roots, in cells as wide as the reach.
class Roots {
public:
    explicit Roots(const Strands& strands) {
        roots_.reserve(strands.size());
        for (std::size_t i = 0; i < strands.size(); ++i) {
            const std::uint32_t first = strands.offsets[i];
            if (first == strands.offsets[i + 1]) continue;
            const Vec3f place = strands.nodes[first];
            roots_.push_back({cellOf(place), place, strands.colors[first]});
        }
        std::ranges::stable_sort(roots_, {}, &Root::cell);
    }

    Growth about(Vec3f place) const {
        float sum = 0;
        Rgb colors;
        for (std::int64_t x = cellAlong(place.x) - 1; x <= cellAlong(place.x) + 1; ++x) {
            for (std::int64_t y = cellAlong(place.y) - 1; y <= cellAlong(place.y) + 1; ++y) {
                const std::int64_t z = cellAlong(place.z);
                // Cells that differ in z alone follow each other.
                const auto begin =
                    std::ranges::lower_bound(roots_, cellKey(x, y, z - 1), {}, &Root::cell);
                const std::uint64_t last = cellKey(x, y, z + 1);
                for (auto root = begin; root != roots_.end() && root->cell <= last; ++root) {
                    const Vec3f offset = root->place - place;
                    const float left = 1 - dot(offset, offset) / (reach * reach);
                    if (left <= 0) continue;
                    sum += left * left;
                    colors += left * left * root->color;
                }
            }
        }
        if (sum == 0) return {};
        // The kernel's integral over the plane is pi reach^2 / 3.
        return {3 * sum / (std::numbers::pi * reach * reach), colors * (1 / sum)};
    }

    /// The median density at the roots [1/m2]; 0 without any.
    double usualDensity() const {
        std::vector<double> densities;
        for (std::size_t i = 0; i < roots_.size(); i += 1 + roots_.size() / samples)
            densities.push_back(about(roots_[i].place).density);
        if (densities.empty()) return 0;
        const auto middle = densities.begin() + static_cast<std::ptrdiff_t>(densities.size() / 2);
        std::ranges::nth_element(densities, middle);
        return *middle;
    }

private:
    std::vector<Root> roots_;
};

}  // namespace

std::vector<Rgb> scalpTint(const Mesh& head, const Strands& strands,
                           const std::optional<Ellipsoid>& scalp, Rgb skin, int threads) {
    std::vector<Rgb> albedo(head.vertices.size(), skin);
    if (strands.colors.empty()) return albedo;
    const Roots roots(strands);
    const double usual = roots.usualDensity();
    if (usual == 0) return albedo;
    const double most = std::min(1.0, usual / thick);
    parallelFor(albedo.size(), 1024, threads, [&](std::size_t begin, std::size_t end) {
        for (std::size_t i = begin; i < end; ++i) {
            const Vec3f vertex = head.vertices[i];
            const Vec3f above =
                scalp ? scalp->point(scalp->angles(vertex.as<double>())).as<float>() : vertex;
            if (length(above - vertex) > mostBelow) continue;
            const Growth growth = roots.about(above);
            const auto share =
                static_cast<float>(most * smoothStep(0.2, 0.8, growth.density / usual));
            albedo[i] = (1 - share) * skin + (share * depth) * growth.color;
        }
    });
    return albedo;
}

}  // namespace kushi
