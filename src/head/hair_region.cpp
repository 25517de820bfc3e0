// SPDX-License-Identifier: Apache-2.0
#include <kushi/head.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>
#include <span>
#include <vector>

namespace kushi {

namespace {

constexpr AngleRange inDegrees(double thetaLow, double thetaHigh, double phiLow, double phiHigh) {
    return {radians(thetaLow), radians(thetaHigh), radians(phiLow), radians(phiHigh)};
}

/// A point of the hairline [degrees]; straight between two of them.
struct EdgePoint {
    double theta, phi;
};

// The right half of the hairline; docs/head.md lists the same points.
constexpr std::array hairline = {EdgePoint{61, 0},  EdgePoint{62, 14}, EdgePoint{64, 28},
                                 EdgePoint{68, 40}, EdgePoint{74, 60}, EdgePoint{77, 63},
                                 EdgePoint{83, 68}, EdgePoint{88, 74}, EdgePoint{91, 81}};
// Before the ear, from its top down to the end of the sideburn ...
constexpr std::array beforeEar = {EdgePoint{74, 105}, EdgePoint{75, 101}, EdgePoint{77, 98},
                                  EdgePoint{83, 94},  EdgePoint{88, 90},  EdgePoint{91, 83}};
// ... and behind it down to the nape.
constexpr std::array behindEar = {EdgePoint{74, 105}, EdgePoint{75, 108},  EdgePoint{77, 111},
                                  EdgePoint{83, 114}, EdgePoint{88, 117},  EdgePoint{93, 121},
                                  EdgePoint{98, 130}, EdgePoint{104, 146}, EdgePoint{106, 158},
                                  EdgePoint{107, 170}};

// Where the edge runs at theta, which lies between its ends.
double phiAt(std::span<const EdgePoint> edge, double theta) {
    std::size_t i = 1;
    while (i + 1 < edge.size() && edge[i].theta < theta)
        ++i;
    const EdgePoint from = edge[i - 1];
    const EdgePoint to = edge[i];
    return from.phi + (theta - from.theta) / (to.theta - from.theta) * (to.phi - from.phi);
}

// Of bands of theta that are so narrow that their ends make a line [degrees].
constexpr double bandWidth = 0.5;

std::vector<AngleRange> insideHairline() {
    std::vector<AngleRange> bands = {inDegrees(0, hairline.front().theta, -180, 180)};
    const double first = hairline.front().theta;
    const auto count = static_cast<int>(std::ceil((behindEar.back().theta - first) / bandWidth));
    for (int i = 0; i < count; ++i) {
        const double theta = first + i * bandWidth;
        const auto add = [&](double from, double to) {
            bands.push_back(inDegrees(theta, theta + bandWidth, from, to));
        };
        const double middle = theta + bandWidth / 2;
        if (middle < beforeEar.front().theta) {
            const double front = phiAt(hairline, middle);
            add(front, 360 - front);
            continue;
        }
        if (middle < beforeEar.back().theta) {
            const double front = phiAt(hairline, middle);
            const double ear = phiAt(beforeEar, middle);
            add(front, ear);
            add(-ear, -front);
        }
        const double back = phiAt(behindEar, middle);
        add(back, 360 - back);
    }
    return bands;
}

// What lies within so much theta behind the hairline of the forehead, down to the temples.
std::vector<AngleRange> behindForehead() {
    constexpr double depth = 9;
    constexpr double temples = 66;
    std::vector<AngleRange> bands;
    constexpr double first = hairline.front().theta - depth;
    constexpr auto count = static_cast<int>((83 - first) / bandWidth);
    for (int i = 0; i < count; ++i) {
        const double theta = first + i * bandWidth;
        const double middle = theta + bandWidth / 2;
        const double from = middle < hairline.front().theta ? 0 : phiAt(hairline, middle);
        const double to = std::min(temples, phiAt(hairline, middle + depth));
        if (from >= to) continue;
        if (from == 0) {
            bands.push_back(inDegrees(theta, theta + bandWidth, -to, to));
        } else {
            bands.push_back(inDegrees(theta, theta + bandWidth, from, to));
            bands.push_back(inDegrees(theta, theta + bandWidth, -to, -from));
        }
    }
    return bands;
}

constexpr std::array crown = {inDegrees(0, 32, -180, 180)};
constexpr std::array top = {inDegrees(0, 62, -60, 60)};
constexpr std::array front = {inDegrees(32, 74, -60, 60)};
constexpr std::array fringe = {inDegrees(46, 70, -42, 42)};
constexpr std::array sides = {inDegrees(32, 107, -112, -60), inDegrees(32, 107, 60, 112)};
constexpr std::array back = {inDegrees(32, 107, 112, 248)};
constexpr std::array nape = {inDegrees(86, 107, 112, 248)};

}  // namespace

bool AngleRange::contains(EllipsoidAngles angles) const {
    if (angles.theta < thetaLow || angles.theta > thetaHigh) return false;
    constexpr double turn = 2 * std::numbers::pi;
    const double past = angles.phi - phiLow;
    return past - turn * std::floor(past / turn) <= phiHigh - phiLow;
}

std::span<const HairZone> hairZones() {
    static const std::vector<AngleRange> band = behindForehead();
    static const std::array zones = {HairZone{"crown", crown},
                                     HairZone{"top", top},
                                     HairZone{"front", front},
                                     HairZone{"fringe", fringe},
                                     HairZone{"hairline", band},
                                     HairZone{"sides", sides},
                                     HairZone{"left", std::span(sides).first(1)},
                                     HairZone{"right", std::span(sides).last(1)},
                                     HairZone{"back", back},
                                     HairZone{"nape", nape}};
    return zones;
}

std::span<const AngleRange> hairZone(std::string_view name) {
    const std::span<const HairZone> zones = hairZones();
    const auto found = std::ranges::find(zones, name, &HairZone::name);
    return found == zones.end() ? std::span<const AngleRange>{} : found->ranges;
}

std::span<const AngleRange> hairRegion() {
    static const std::vector<AngleRange> bands = insideHairline();
    return bands;
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
