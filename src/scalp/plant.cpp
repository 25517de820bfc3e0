// SPDX-License-Identifier: Apache-2.0
#include "core/random.h"
#include "scalp/lattice.h"
#include "style/ranges.h"

#include <kushi/follicles.h>

#include <algorithm>
#include <cmath>
#include <numbers>
#include <string>

namespace kushi {

namespace {

constexpr double pi = std::numbers::pi;
constexpr double mostSites = 20e6;
constexpr std::size_t mostFollicles = 5000000;

enum Salt : std::uint64_t { RowPhase = 1, JitterTheta = 2, JitterPhi = 3 };

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

Follicles plantWithSpacing(const Scalp& scalp, const ArcLength& meridian, double spacing,
                           std::uint64_t seed) {
    const Ellipsoid& ellipsoid = scalp.ellipsoid;
    const double reach = 0.5 * scalp.jitter * spacing;
    Follicles follicles;
    follicles.spacing = spacing;

    const ArcLength around = equator(ellipsoid);
    const auto rows = static_cast<std::uint64_t>(std::ceil(meridian.total() / spacing - 0.5));
    for (std::uint64_t row = 0; row < rows; ++row) {
        const double theta = meridian.parameterAt((static_cast<double>(row) + 0.5) * spacing);
        const double scale = std::sin(theta);
        const double total = scale * around.total();
        const double places = std::max(1.0, std::round(total / spacing));
        const std::uint64_t rowKey = mixKey(seed, row);
        const double phase = uniform(mixKey(rowKey, RowPhase));

        for (std::uint64_t column = 0; column < static_cast<std::uint64_t>(places); ++column) {
            const std::uint64_t key = mixKey(rowKey, 16 + column);
            double along = (static_cast<double>(column) + phase) * total / places;
            along += reach * uniformSigned(mixKey(key, JitterPhi));
            along -= total * std::floor(along / total);

            EllipsoidAngles at = {theta, around.parameterAt(along / scale)};
            at.theta +=
                reach * uniformSigned(mixKey(key, JitterTheta)) / meridianSpeed(ellipsoid, at);
            at = properAngles(at);
            if (!contains(scalp.regions, at)) continue;

            follicles.roots.push_back(ellipsoid.point(at));
            follicles.angles.push_back(at);
            follicles.keys.push_back(key);
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
            const Vec3d a = ellipsoid.semiAxes;
            const double st = std::sin(theta);
            const double ct = std::cos(theta);
            const Vec3d byTheta = {a.x * ct * std::cos(phi), -a.y * st, a.z * ct * std::sin(phi)};
            const Vec3d byPhi = {-a.x * st * std::sin(phi), 0, a.z * st * std::cos(phi)};
            area += length(cross(byTheta, byPhi));
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
Result<Follicles> plantCount(const Scalp& scalp, const ArcLength& meridian, std::size_t count,
                             std::uint64_t seed) {
    const double area = surfaceArea(scalp.ellipsoid);
    const auto wanted = static_cast<double>(count);
    double fine = 0;                        // a spacing known to give enough
    double coarse = std::sqrt(area) * 100;  // one that gives too few
    double guess = std::sqrt(area / wanted);
    Follicles enough;
    for (int round = 0; round < 60; ++round) {
        if (area / (guess * guess) > mostSites) {
            return Problem{"the regions are too small for " + std::to_string(count) +
                           " follicles; widen them or give a smaller count"};
        }
        Follicles planted = plantWithSpacing(scalp, meridian, guess, seed);
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

}  // namespace

Result<Follicles> plant(const Scalp& scalp, std::uint64_t seed) {
    const ArcLength meridian = meanMeridian(scalp.ellipsoid);
    if (scalp.count)
        return plantCount(scalp, meridian, static_cast<std::size_t>(*scalp.count), seed);
    const double spacing = *scalp.spacing;
    if (surfaceArea(scalp.ellipsoid) / (spacing * spacing) > mostSites) return tooMany();
    Follicles planted = plantWithSpacing(scalp, meridian, spacing, seed);
    if (planted.size() > mostFollicles) return tooMany();
    return planted;
}

}  // namespace kushi
