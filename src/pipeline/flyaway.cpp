// SPDX-License-Identifier: Apache-2.0
#include "pipeline/flyaway.h"

#include "core/random.h"
#include "pipeline/aside.h"
#include "pipeline/retrace.h"

#include <kushi/strands.h>

#include <algorithm>
#include <cmath>
#include <numbers>
#include <vector>

namespace kushi {

namespace {

constexpr std::uint64_t choiceSalt = 0x666c796177617973;
constexpr std::uint64_t sizeSalt = 0x666c7973697a65;
constexpr std::uint64_t lengthSalt = 0x666c796c656e;
constexpr std::uint64_t outwardSalt = 0x666c796f7574;
constexpr std::uint64_t sidewaysSalt = 0x666c7973696465;
constexpr double shortest = 0.7;  // of its former length
constexpr double farthest = 1.0 / 3;

// 0 at the root, at most 1: a bow with a swing of a quarter of a turn to three.
double swing(std::uint64_t key, std::uint64_t salt, double t) {
    const std::uint64_t own = mixKey(key, salt);
    const double phase = 2 * std::numbers::pi * uniform(mixKey(own, 1));
    const double turns = 0.25 + 0.5 * uniform(mixKey(own, 2));
    return t * std::sin(phase + 2 * std::numbers::pi * turns * t);
}

}  // namespace

bool isFlyaway(const Flyaway& flyaway, std::uint64_t key) {
    return uniform(mixKey(key, choiceSalt)) < flyaway.share;
}

void flyAway(const Flyaway& flyaway, std::uint64_t key, Vec3d middle, std::span<Vec3f> nodes) {
    const double whole = polylineLength(nodes);
    // The first segment comes out of the skin, as it did.
    const double first = polylineLength(nodes.first(2));
    if (!(whole > first)) return;
    // Most of them a little, a few a lot.
    const double lot = uniform(mixKey(key, sizeSalt));
    const double most = std::min(flyaway.distance * (0.2 + 1.6 * lot * lot), farthest * whole);
    std::vector<Vec3d> wanted;
    double walked = 0;
    for (std::size_t j = 0; j < nodes.size(); ++j) {
        const Vec3d place = nodes[j].as<double>();
        if (j > 0) walked += length(place - nodes[j - 1].as<double>());
        const double t = std::max(0.0, walked - first) / (whole - first);
        const Vec3d tangent =
            (nodes[std::min(j + 1, nodes.size() - 1)] - nodes[j > 0 ? j - 1 : 0]).as<double>();
        const auto [outward, sideways] = asideOf(place, tangent, middle);
        const double out = t * (0.6 + 0.4 * swing(key, outwardSalt, t));
        const double aside = 0.5 * swing(key, sidewaysSalt, t);
        wanted.push_back(place + most * t * (out * outward + aside * sideways));
    }
    const double scale = 1 - (1 - shortest) * uniform(mixKey(key, lengthSalt));
    retrace(wanted, scale, nodes);
}

}  // namespace kushi
