// SPDX-License-Identifier: Apache-2.0
#include "pipeline/tie_up.h"

#include "core/random.h"
#include "pipeline/start_along.h"
#include "style/ranges.h"

#include <algorithm>
#include <cmath>

namespace kushi {

namespace {

constexpr double spring = 0.03;  // hair turns down within so much behind a tie [m]
constexpr std::uint64_t radiusSalt = 0x7469652d72;
constexpr std::uint64_t slackSalt = 0x7469652d73;

// Where in a tie's disc a strand goes through it: on the side that it comes from.
Vec3d placeIn(const HairTie& tie, Vec3d center, Vec3d root, std::uint64_t key) {
    const Vec3d out = normalized(tie.at - center);
    const Vec3d from = root - tie.at;
    const Vec3d side = from - dot(from, out) * out;
    const double size = length(side);
    if (size < 1e-9) return tie.at;
    const double distance = tie.radius * std::sqrt(uniform(mixKey(key, radiusSalt)));
    return tie.at + (distance / size) * side;
}

// Which way a strand goes that has walked so far.
Vec3d directionAt(const WayToTie& way, double walked, Vec3d down) {
    if (walked <= way.walked) {
        return way.route.directionAt(walked / way.walked * way.route.length);
    }
    const double share = std::min(1.0, (walked - way.walked) / spring);
    const Vec3d arrival = way.route.directionAt(way.route.length);
    const Vec3d between = (1 - share) * arrival + share * down;
    return length(between) > 1e-3 ? normalized(between) : arrival;
}

}  // namespace

std::optional<WayToTie> wayToTie(const Part& part, Vec3d root, EllipsoidAngles angles,
                                 std::uint64_t key, double length) {
    const Ellipsoid& head = part.scalp.ellipsoid;
    const auto tie = std::ranges::find_if(
        part.ties, [&](const HairTie& one) { return share(one.roots, angles, 0) > 0; });
    if (tie == part.ties.end()) return std::nullopt;
    WayToTie way;
    way.route = around(head, root, placeIn(*tie, head.center, root, key), overHead);
    const double slack = tie->slack * (0.5 + uniform(mixKey(key, slackSalt)));
    way.walked = way.route.length * (1 + slack);
    if (way.walked >= length) return std::nullopt;
    return way;
}

std::vector<Tie> layAlong(std::span<const WayToTie> ways, Vec3d gravity, Rods& rods) {
    const Vec3d down = fallOf(gravity);
    std::vector<Tie> ties;
    for (std::uint32_t i = 0; i < ways.size(); ++i) {
        const auto segments = static_cast<std::uint32_t>(rods.segments(i));
        startAlong(rods, i, [&](double walked) { return directionAt(ways[i], walked, down); });
        std::uint32_t tied = 1;
        for (double walked = rods.segmentLength(i, 0); tied < segments && walked < ways[i].walked;)
            walked += rods.segmentLength(i, tied++);
        ties.push_back({i, tied, ways[i].route.points.back().as<float>()});
    }
    return ties;
}

}  // namespace kushi
