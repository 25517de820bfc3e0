// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <kushi/style.h>

#include <algorithm>
#include <cmath>
#include <numbers>
#include <span>

namespace kushi {

/// 1 where `signedDistance` lies well inside an edge, 0 well outside, with a smooth ramp of `width`
/// centred on the edge itself; a hard step, closed, where width is 0.
inline double edgeShare(double signedDistance, double width) {
    if (width <= 0) return signedDistance >= 0 ? 1 : 0;
    const double t = std::clamp(signedDistance / width + 0.5, 0.0, 1.0);
    return t * t * (3 - 2 * t);
}

/// Share of a range that `value` receives; infinite ends have no edge.
inline double share(const Range& range, double value, double width = 0) {
    return edgeShare(value - range.low, width) * edgeShare(range.high - value, width);
}

inline double share(const Box& box, Vec3d point, double width = 0) {
    return share(box.x, point.x, width) * share(box.y, point.y, width) *
           share(box.z, point.z, width);
}

/// Share of a root range. The poles are not edges of a range that reaches them, nor is anything an
/// edge of a range of phi that goes all the way round.
inline double share(const RootRange& roots, EllipsoidAngles at, double width = 0) {
    constexpr double pi = std::numbers::pi;
    constexpr double infinity = std::numeric_limits<double>::infinity();
    constexpr double tiny = 1e-9;
    Range theta = roots.theta;
    if (theta.low <= 0) theta.low = -infinity;
    if (theta.high >= pi) theta.high = infinity;
    const double byTheta = share(theta, at.theta, width);
    if (byTheta <= 0 || roots.phi.high - roots.phi.low >= 2 * pi - tiny) return byTheta;

    double best = 0;
    for (const double turn : {-2 * pi, 0.0, 2 * pi}) {
        best = std::max(best, share(roots.phi, at.phi + turn, width));
    }
    return byTheta * best;
}

/// Share of a union: the largest of its ranges'.
inline double share(std::span<const RootRange> roots, EllipsoidAngles at, double width = 0) {
    double best = 0;
    for (const RootRange& range : roots)
        best = std::max(best, share(range, at, width));
    return best;
}

/// Whether a root range, whose ends belong to it, holds a follicle.
inline bool contains(const RootRange& roots, EllipsoidAngles at) {
    return share(roots, at) > 0;
}

inline bool contains(std::span<const RootRange> roots, EllipsoidAngles at) {
    return std::ranges::any_of(roots, [at](const RootRange& r) { return contains(r, at); });
}

/// The ranges that may hold what lies at most `reach` from a row of constant theta, over a pole
/// too [rad].
inline RootRanges rangesNear(std::span<const RootRange> roots, double theta, double reach) {
    RootRanges near;
    for (const RootRange& range : roots) {
        if (theta >= range.theta.low - reach && theta <= range.theta.high + reach)
            near.push_back(range);
    }
    return near;
}

}  // namespace kushi
