// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "scalp/head_surface.h"
#include "scalp/lattice.h"

#include <vector>

namespace kushi {

/// How much area of a head lies over each piece of the scalp's ellipsoid, once for all spacings:
/// what makes rows of follicles as dense on the head as they are to be.
class AreaMap {
public:
    /// Refuses a head that lies nowhere under the scalp's regions, and a mask where the head there
    /// has no texture coordinates.
    static Result<AreaMap> of(const Scalp& scalp, const HeadSurface& head);

    /// The mean meridian on the head: theta by distance from the whorl.
    ArcLength meridian() const;

    /// The row from one theta to another: phi in [0, 2 pi] by area over `height` [m].
    ArcLength row(double thetaLow, double thetaHigh, double height) const;

private:
    static constexpr std::size_t rows = 180;
    static constexpr std::size_t columns = 360;

    explicit AreaMap(const Ellipsoid& ellipsoid) : ellipsoid_(ellipsoid) {}

    static EllipsoidAngles middle(std::size_t row, std::size_t column);
    float ratio(std::size_t row, std::size_t column) const {
        return ratios_[row * columns + column];
    }

    Ellipsoid ellipsoid_;
    std::vector<float> ratios_;  // area on the head over that on the ellipsoid; mean where no head
};

}  // namespace kushi
