// SPDX-License-Identifier: Apache-2.0
#include <kushi/head.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>

namespace kushi {

namespace {

constexpr AngleRange inDegrees(double thetaLow, double thetaHigh, double phiLow, double phiHigh) {
    return {radians(thetaLow), radians(thetaHigh), radians(phiLow), radians(phiHigh)};
}

// Bands of theta; each leaves out the forehead and, further down, the ears and the neck's sides.
constexpr std::array region = {
    inDegrees(0, 62, -180, 180),  inDegrees(62, 66, 28, 332),  inDegrees(66, 70, 40, 320),
    inDegrees(70, 74, 52, 308),   inDegrees(74, 80, 62, 98),   inDegrees(74, 80, 262, 298),
    inDegrees(74, 80, 111, 249),  inDegrees(80, 86, 68, 94),   inDegrees(80, 86, 266, 292),
    inDegrees(80, 86, 114, 246),  inDegrees(86, 91, 74, 90),   inDegrees(86, 91, 270, 286),
    inDegrees(86, 91, 117, 243),  inDegrees(91, 95, 121, 239), inDegrees(95, 101, 130, 230),
    inDegrees(101, 107, 146, 214)};

constexpr std::array crown = {inDegrees(0, 32, -180, 180)};
constexpr std::array top = {inDegrees(0, 62, -60, 60)};
constexpr std::array front = {inDegrees(32, 74, -60, 60)};
constexpr std::array fringe = {inDegrees(46, 70, -42, 42)};
constexpr std::array sides = {inDegrees(32, 107, -112, -60), inDegrees(32, 107, 60, 112)};
constexpr std::array back = {inDegrees(32, 107, 112, 248)};
constexpr std::array nape = {inDegrees(86, 107, 112, 248)};

constexpr std::array zones = {HairZone{"crown", crown},
                              HairZone{"top", top},
                              HairZone{"front", front},
                              HairZone{"fringe", fringe},
                              HairZone{"sides", sides},
                              HairZone{"left", std::span(sides).first(1)},
                              HairZone{"right", std::span(sides).last(1)},
                              HairZone{"back", back},
                              HairZone{"nape", nape}};

}  // namespace

bool AngleRange::contains(EllipsoidAngles angles) const {
    if (angles.theta < thetaLow || angles.theta > thetaHigh) return false;
    constexpr double turn = 2 * std::numbers::pi;
    const double past = angles.phi - phiLow;
    return past - turn * std::floor(past / turn) <= phiHigh - phiLow;
}

std::span<const HairZone> hairZones() {
    return zones;
}

std::span<const AngleRange> hairZone(std::string_view name) {
    const auto* const found = std::ranges::find(zones, name, &HairZone::name);
    return found == zones.end() ? std::span<const AngleRange>{} : found->ranges;
}

std::span<const AngleRange> hairRegion() {
    return region;
}

std::vector<std::uint8_t> scalpTriangles(const Mesh& head) {
    constexpr double reach = 0.02;
    const Ellipsoid ellipsoid = headEllipsoid();
    std::vector<std::uint8_t> flags;
    flags.reserve(head.triangles.size());
    for (const auto& [a, b, c] : head.triangles) {
        const Vec3f sum = head.vertices[a] + head.vertices[b] + head.vertices[c];
        const Vec3d middle = sum.as<double>() / 3;
        const EllipsoidAngles angles = ellipsoid.angles(middle);
        const bool grows = std::ranges::any_of(
            hairRegion(), [&](const AngleRange& range) { return range.contains(angles); });
        flags.push_back(grows && ellipsoid.depth(middle) < reach ? 1 : 0);
    }
    return flags;
}

}  // namespace kushi
