// SPDX-License-Identifier: Apache-2.0
#include "scalp/border.h"

#include "style/ranges.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>

namespace kushi {

namespace {

// Where the regions end between two places of which they hold just one.
Vec3d crossing(const Scalp& scalp, EllipsoidAngles inside, EllipsoidAngles outside) {
    constexpr int halvings = 10;
    for (int i = 0; i < halvings; ++i) {
        const EllipsoidAngles middle = {0.5 * (inside.theta + outside.theta),
                                        0.5 * (inside.phi + outside.phi)};
        (contains(scalp.regions, middle) ? inside : outside) = middle;
    }
    return scalp.ellipsoid.point(inside);
}

// The crossings along the lines of a grid, as fine as the edge asks for.
std::vector<Vec3d> crossings(const Scalp& scalp) {
    constexpr int coarsest = 180;
    constexpr int finest = 500;
    const Vec3d axes = scalp.ellipsoid.semiAxes;
    const double around = std::numbers::pi * std::max({axes.x, axes.y, axes.z});
    const int rows =
        static_cast<int>(std::clamp(6 * around / scalp.edge, double{coarsest}, double{finest}));
    const int columns = 2 * rows;
    const auto at = [rows](int row, int column) {
        const double step = std::numbers::pi / rows;
        return EllipsoidAngles{step * (row + 0.5), step * (column + 0.5) - std::numbers::pi};
    };
    std::array<std::vector<bool>, 2> held;  // of a row and the one before
    std::vector<Vec3d> points;
    for (int row = 0; row < rows; ++row) {
        std::swap(held[0], held[1]);
        held[0].clear();
        const RootRanges inRow = rangesNear(scalp.regions, at(row, 0).theta, 0);
        for (int column = 0; column < columns; ++column)
            held[0].push_back(contains(inRow, at(row, column)));

        const auto compare = [&](bool here, bool there, EllipsoidAngles a, EllipsoidAngles b) {
            if (here != there) points.push_back(crossing(scalp, here ? a : b, here ? b : a));
        };
        for (int column = 0; column < columns; ++column) {
            const auto i = static_cast<std::size_t>(column);
            const bool here = held[0][i];
            compare(here, held[0][(i + 1) % held[0].size()], at(row, column), at(row, column + 1));
            if (row > 0) compare(here, held[1][i], at(row, column), at(row - 1, column));
        }
    }
    return points;
}

}  // namespace

Border::Border(const Scalp& scalp)
    : edge_(scalp.edge),
      points_(crossings(scalp)),
      cloud_{points_},
      tree_(3, cloud_, nanoflann::KDTreeSingleIndexAdaptorParams(16)) {}

double Border::share(Vec3d place) const {
    if (points_.empty()) return 1;
    const std::array<double, 3> query = {place.x, place.y, place.z};
    std::size_t nearest = 0;
    double squared = 0;
    tree_.knnSearch(query.data(), 1, &nearest, &squared);
    return std::min(1.0, std::sqrt(squared) / edge_);
}

}  // namespace kushi
