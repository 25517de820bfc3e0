// SPDX-License-Identifier: Apache-2.0
#include "scalp/area_map.h"

#include "style/ranges.h"

#include <algorithm>
#include <cmath>
#include <numbers>

namespace kushi {

namespace {

constexpr double pi = std::numbers::pi;

// A surface seen almost from its edge holds more hair than there is room for on the line to it.
constexpr double steepest = 0.2;

// Of the areas that a narrow cone from the centre cuts out of the head and of the ellipsoid.
double areaRatio(const Ellipsoid& ellipsoid, Vec3d point, const HeadSurface::Place& place) {
    const Vec3d way = point - ellipsoid.center;
    const double away = length(way);
    const double size = length(place.point - ellipsoid.center) / away;
    const double here = dot(ellipsoid.normal(point), way) / away;
    const double there = std::max(steepest, dot(place.flatNormal, way) / away);
    return size * size * here / there;
}

}  // namespace

EllipsoidAngles AreaMap::middle(std::size_t row, std::size_t column) {
    const double phi = 2 * pi * (static_cast<double>(column) + 0.5) / columns;
    return {pi * (static_cast<double>(row) + 0.5) / rows, phi < pi ? phi : phi - 2 * pi};
}

Result<AreaMap> AreaMap::of(const Scalp& scalp, const HeadSurface& head) {
    AreaMap map(scalp.ellipsoid);
    double sum = 0;
    int found = 0;
    std::size_t asked = 0;  // within the regions, which may be narrower than the map is fine
    std::size_t grown = 0;
    for (std::size_t i = 0; i < rows * columns; ++i) {
        const EllipsoidAngles at = middle(i / columns, i % columns);
        const Vec3d point = scalp.ellipsoid.point(at);
        const auto place = head.at(point);
        map.ratios_.push_back(place ? static_cast<float>(areaRatio(scalp.ellipsoid, point, *place))
                                    : 0.0F);
        const bool within = contains(scalp.regions, at);
        asked += within ? 1 : 0;
        if (!place) continue;
        sum += map.ratios_.back();
        ++found;
        if (!within) continue;
        ++grown;
        if (std::isnan(place->share)) {
            return Problem{
                "mask: the head has no texture coordinates on part of where hair grows; give "
                "'groups' that have them",
                scalp.maskPlace.file, scalp.maskPlace.line, scalp.maskPlace.column};
        }
    }
    if (found == 0 || (asked > 0 && grown == 0)) {
        return Problem{
            "nothing of the head's surface that hair may grow on lies under the scalp's regions, "
            "from its ellipsoid's centre to 2 cm outside of it; check 'groups' and 'regions', and "
            "'unit' and 'offset' in [head]",
            scalp.surfacePlace.file, scalp.surfacePlace.line, scalp.surfacePlace.column};
    }
    std::ranges::replace(map.ratios_, 0.0F, static_cast<float>(sum / found));
    return map;
}

ArcLength AreaMap::meridian() const {
    std::vector<double> steps;
    for (std::size_t row = 0; row < rows; ++row) {
        double sum = 0;
        for (std::size_t column = 0; column < columns; ++column) {
            sum += meridianSpeed(ellipsoid_, middle(row, column)) *
                   std::sqrt(static_cast<double>(ratio(row, column)));
        }
        steps.push_back(sum / columns * pi / rows);
    }
    return {0, pi, steps};
}

ArcLength AreaMap::row(double thetaLow, double thetaHigh, double height) const {
    const double theta = (thetaLow + thetaHigh) / 2;
    // Between the rows of the map.
    const double place = std::clamp(theta / pi * rows - 0.5, 0.0, rows - 1.0);
    const std::size_t above = std::min(static_cast<std::size_t>(place), rows - 2);
    const double share = place - static_cast<double>(above);
    const double width = (thetaHigh - thetaLow) * 2 * pi / columns / height;
    std::vector<double> steps;
    for (std::size_t column = 0; column < columns; ++column) {
        const double blended =
            (1 - share) * ratio(above, column) + share * ratio(above + 1, column);
        const EllipsoidAngles at = {theta, middle(0, column).phi};
        steps.push_back(blended * areaSpeed(ellipsoid_, at) * width);
    }
    return {0, 2 * pi, steps};
}

}  // namespace kushi
