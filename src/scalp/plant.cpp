// SPDX-License-Identifier: Apache-2.0
#include "core/random.h"
#include "scalp/area_map.h"
#include "scalp/border.h"
#include "scalp/head_surface.h"
#include "scalp/lattice.h"
#include "style/ranges.h"

#include <kushi/follicles.h>

#include <algorithm>
#include <cmath>
#include <numbers>
#include <optional>
#include <string>

namespace kushi {

namespace {

constexpr double pi = std::numbers::pi;
constexpr double mostSites = 20e6;
constexpr std::size_t mostFollicles = 5000000;

enum Salt : std::uint64_t { RowPhase = 1, JitterTheta = 2, JitterPhi = 3, Share = 4 };

// Angles that have been moved over a pole or past +-pi, as the same point's proper ones.
EllipsoidAngles properAngles(EllipsoidAngles at) {
    if (at.theta < 0 || at.theta > pi) {
        at.theta = at.theta < 0 ? -at.theta : 2 * pi - at.theta;
        at.phi += pi;
    }
    at.phi = std::remainder(at.phi, 2 * pi);
    if (at.phi >= pi) at.phi -= 2 * pi;
    return at;
}

/// Where follicles stand: on the ellipsoid, or carried from it to a head.
struct Ground {
    const Scalp& scalp;
    const Border* border;  // if it is soft
    ArcLength meridian;    // by which rows are spaced
    const HeadSurface* head = nullptr;
    const AreaMap* areas = nullptr;  // of the head
};

// Puts a follicle down where its angles are; nothing grows where there is no head, or no paint, and
// less towards the border.
void put(const Ground& ground, EllipsoidAngles at, std::uint64_t key, Follicles& follicles) {
    Vec3d root = ground.scalp.ellipsoid.point(at);
    Vec3d normal = ground.scalp.ellipsoid.normal(root);
    double share = ground.border != nullptr ? ground.border->share(root) : 1;
    if (ground.head != nullptr) {
        const auto place = ground.head->at(root);
        if (!place) return;
        root = place->point;
        normal = place->normal;
        share *= place->share;
    }
    if (!(uniform(mixKey(key, Share)) < share)) return;
    if (ground.scalp.mask || ground.border != nullptr)
        follicles.shares.push_back(static_cast<float>(share));
    follicles.roots.push_back(root);
    follicles.normals.push_back(normal);
    follicles.angles.push_back(at);
    follicles.keys.push_back(key);
}

/// A row of constant theta.
struct Row {
    double theta = 0;
    ArcLength along;    // phi: by arc length on an ellipsoid's equator, by area on a head
    double scale = 1;   // the row's length over that
    double height = 0;  // on a head, in theta [rad]
};

Row rowOf(const Ground& ground, const ArcLength& around, double low, double spacing) {
    const double theta = ground.meridian.parameterAt(low + 0.5 * spacing);
    if (ground.areas == nullptr) return {theta, around, std::sin(theta)};
    const double begin = ground.meridian.parameterAt(low);
    const double end =
        ground.meridian.parameterAt(std::min(low + spacing, ground.meridian.total()));
    return {theta, ground.areas->row(begin, end, spacing), 1, end - begin};
}

Follicles plantWithSpacing(const Ground& ground, double spacing, std::uint64_t seed) {
    const Scalp& scalp = ground.scalp;
    const Ellipsoid& ellipsoid = scalp.ellipsoid;
    const double reach = 0.5 * scalp.jitter * spacing;
    Follicles follicles;
    follicles.spacing = spacing;

    const Vec3d axes = ellipsoid.semiAxes;
    const double leastSpeed = std::min({axes.x, axes.y, axes.z});  // of a meridian
    const ArcLength around = equator(ellipsoid);
    const auto rows =
        static_cast<std::uint64_t>(std::ceil(ground.meridian.total() / spacing - 0.5));
    for (std::uint64_t i = 0; i < rows; ++i) {
        const Row row = rowOf(ground, around, static_cast<double>(i) * spacing, spacing);
        const double turn =
            row.height > 0 ? reach / spacing * row.height : reach / leastSpeed;  // at most
        const RootRanges regions = rangesNear(scalp.regions, row.theta, turn);
        if (regions.empty()) continue;
        const double total = row.scale * row.along.total();
        const double places = std::max(1.0, std::round(total / spacing));
        const std::uint64_t rowKey = mixKey(seed, i);
        const double phase = uniform(mixKey(rowKey, RowPhase));

        for (std::uint64_t column = 0; column < static_cast<std::uint64_t>(places); ++column) {
            const std::uint64_t key = mixKey(rowKey, 16 + column);
            double along = (static_cast<double>(column) + phase) * total / places;
            along += reach * uniformSigned(mixKey(key, JitterPhi));
            along -= total * std::floor(along / total);

            EllipsoidAngles at = {row.theta, row.along.parameterAt(along / row.scale)};
            const double aside = reach * uniformSigned(mixKey(key, JitterTheta));
            at.theta += row.height > 0 ? aside / spacing * row.height
                                       : aside / meridianSpeed(ellipsoid, at);
            at = properAngles(at);
            if (contains(regions, at)) put(ground, at, key, follicles);
        }
    }
    return follicles;
}

double surfaceArea(const Ellipsoid& ellipsoid) {
    constexpr int rows = 64;
    double area = 0;
    for (int row = 0; row < rows; ++row) {
        const double theta = pi * (row + 0.5) / rows;
        for (int i = 0; i < rows; ++i) {
            const double phi = 2 * pi * i / rows;
            area += areaSpeed(ellipsoid, {theta, phi});
        }
    }
    return area * (pi / rows) * (2 * pi / rows);
}

Problem tooMany() {
    return {
        "the scalp asks for more than 5,000,000 follicles, or 20,000,000 if the whole ellipsoid "
        "bore "
        "hair; give a larger spacing, a smaller count or wider regions"};
}

// The follicles at the largest spacing found that gives at least `count`, and the surplus taken
// out.
Result<Follicles> plantCount(const Ground& ground, std::size_t count, std::uint64_t seed) {
    const double area = surfaceArea(ground.scalp.ellipsoid);
    const auto wanted = static_cast<double>(count);
    double fine = 0;                        // a spacing known to give enough
    double coarse = std::sqrt(area) * 100;  // one that gives too few
    double guess = std::sqrt(area / wanted);
    Follicles enough;
    for (int round = 0; round < 60; ++round) {
        if (area / (guess * guess) > mostSites) {
            return Problem{"the regions are too small for " + std::to_string(count) +
                           " follicles; widen them or give a smaller count" +
                           (ground.border != nullptr ? " or edge" : "")};
        }
        Follicles planted = plantWithSpacing(ground, guess, seed);
        const auto number = static_cast<double>(planted.size());
        (number >= wanted ? fine : coarse) = guess;
        if (number >= wanted) enough = std::move(planted);
        if (number >= wanted && number <= 1.002 * wanted + 1) break;

        // The number goes with 1 / spacing^2; aim a little above, and fall back on halving.
        guess *= std::sqrt(std::max(number, 0.05) / (1.001 * wanted));
        if (guess <= fine || guess >= coarse)
            guess = fine > 0 ? 0.5 * (fine + coarse) : 0.5 * coarse;
        if (coarse - fine < 1e-9 * coarse) break;
    }
    return thin(enough, count);
}

Result<Follicles> plantOn(const Ground& ground, std::uint64_t seed) {
    const Scalp& scalp = ground.scalp;
    if (scalp.count) return plantCount(ground, static_cast<std::size_t>(*scalp.count), seed);
    const double spacing = *scalp.spacing;
    if (surfaceArea(scalp.ellipsoid) / (spacing * spacing) > mostSites) return tooMany();
    Follicles planted = plantWithSpacing(ground, spacing, seed);
    if (planted.size() > mostFollicles) return tooMany();
    return planted;
}

}  // namespace

Result<Follicles> plant(const Scalp& scalp, std::uint64_t seed, const Mesh& head) {
    std::optional<Border> soft;
    if (scalp.edge > 0) soft.emplace(scalp);
    const Border* border = soft ? &*soft : nullptr;
    if (scalp.surface == ScalpSurface::Ellipsoid)
        return plantOn({scalp, border, meanMeridian(scalp.ellipsoid)}, seed);
    const Result<HeadSurface> surface = HeadSurface::of(scalp, head);
    if (!surface) return surface.problems();
    const Result<AreaMap> areas = AreaMap::of(scalp, *surface);
    if (!areas) return areas.problems();
    return plantOn({scalp, border, areas->meridian(), &*surface, &*areas}, seed);
}

}  // namespace kushi
