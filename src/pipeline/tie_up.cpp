// SPDX-License-Identifier: Apache-2.0
#include "pipeline/tie_up.h"

#include "core/random.h"
#include "style/ranges.h"

#include <algorithm>
#include <cmath>

namespace kushi {

namespace {

constexpr double clearance = 0.003;  // of the ways over the head [m]
constexpr double spring = 0.03;      // hair turns down within so much behind a tie [m]
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

// The rotation that takes the unit vector `from` to `to` by the shortest way, then `frame`'s.
Frame carried(const Frame& frame, Vec3d from, Vec3d to) {
    const Vec3d axis = cross(from, to);
    const double w = 1 + dot(from, to);
    if (w < 1e-6) return frameAlong(to);
    const double scale = 1 / std::sqrt(w * w + dot(axis, axis));
    const double rw = scale * w;
    const Vec3d r = scale * axis;
    const double fw = frame.w;
    const Vec3d f = {frame.x, frame.y, frame.z};
    const Vec3d v = rw * f + fw * r + cross(r, f);
    return {static_cast<float>(rw * fw - dot(r, f)), static_cast<float>(v.x),
            static_cast<float>(v.y), static_cast<float>(v.z)};
}

double segmentLength(const Rods& rods, std::size_t strand, std::size_t segment) {
    if (rods.segmentLengths.empty())
        return rods.lengths[strand] / static_cast<double>(rods.segments(strand));
    return rods.segmentLengths[rods.offsets[strand] + segment];
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
    way.route = around(head, root, placeIn(*tie, head.center, root, key), clearance);
    const double slack = tie->slack * (0.5 + uniform(mixKey(key, slackSalt)));
    way.walked = way.route.length * (1 + slack);
    if (way.walked >= length) return std::nullopt;
    return way;
}

std::vector<Tie> layAlong(std::span<const WayToTie> ways, Vec3d gravity, Rods& rods) {
    const Vec3d down = length(gravity) > 0 ? normalized(gravity) : Vec3d{0, -1, 0};
    std::vector<Tie> ties;
    for (std::uint32_t i = 0; i < ways.size(); ++i) {
        const std::size_t segments = rods.segments(i);
        Frame frame = rods.clamps[i];
        Vec3d direction = directionOf(frame);
        double walked = 0;
        std::uint32_t tied = 0;
        for (std::uint32_t j = 1; j <= segments; ++j) {
            walked += segmentLength(rods, i, j - 1);
            const Vec3d next = directionAt(ways[i], walked, down);
            frame = carried(frame, direction, next);
            direction = next;
            rods.starts.push_back(frame);
            if (tied == 0 && (walked >= ways[i].walked || j == segments)) tied = j;
        }
        ties.push_back({i, tied, ways[i].route.points.back().as<float>()});
    }
    return ties;
}

}  // namespace kushi
