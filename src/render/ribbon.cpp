// SPDX-License-Identifier: Apache-2.0
#include "render/ribbon.h"

#include <cmath>
#include <optional>

namespace kushi {

namespace {

struct Direction {
    double x = 0, y = 0;
};

/// The direction of a segment on the picture; none if it is seen along its axis.
std::optional<Direction> directionOf(const ScreenSegment& segment) {
    const double x = segment.b.x - segment.a.x;
    const double y = segment.b.y - segment.a.y;
    const double size = std::sqrt(x * x + y * y);
    if (!(size > 1e-6)) return std::nullopt;
    return Direction{x / size, y / size};
}

std::optional<Direction> directionFrom(const Scene& scene, std::uint32_t node) {
    const std::optional<ScreenSegment> segment = scene.segment(node);
    return segment ? directionOf(*segment) : std::nullopt;
}

/// From a node to its corner, for a strand two wide: on the line that halves the angle between the
/// segments that meet there.
Direction mitre(Direction one, std::optional<Direction> other) {
    const Direction along = other.value_or(one);
    const double cosine = one.x * along.x + one.y * along.y;
    if (cosine < 0) return {-one.y, one.x};
    return {-(one.y + along.y) / (1 + cosine), (one.x + along.x) / (1 + cosine)};
}

}  // namespace

ScreenPolygon ribbonOf(const Scene& scene, std::uint32_t node, const ScreenSegment& segment) {
    const std::optional<Direction> direction = directionOf(segment);
    if (!direction) return {};
    const bool startsHere = segment.from > 0 || scene.beginsStrand(node);
    const bool endsHere = segment.to < 1 || scene.endsStrand(node + 1);
    const Direction first =
        mitre(*direction, startsHere ? std::nullopt : directionFrom(scene, node - 1));
    const Direction last =
        mitre(*direction, endsHere ? std::nullopt : directionFrom(scene, node + 1));

    const auto corner = [](const ScreenPoint& at, Direction side, double sign) {
        const double half = sign * 0.5 * at.width;
        return ScreenPolygon::Corner{{at.x + half * side.x, at.y + half * side.y, at.q}, {}};
    };
    return {{corner(segment.a, first, -1), corner(segment.a, first, 1), corner(segment.b, last, 1),
             corner(segment.b, last, -1)},
            4};
}

}  // namespace kushi
