// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <kushi/ellipsoid.h>

#include <vector>

namespace kushi {

/// Arc length along a curve with a parameter, tabulated once and inverted by interpolation.
class ArcLength {
public:
    /// Length of each of the equal steps of the parameter from `begin` to `end`.
    ArcLength(double begin, double end, const std::vector<double>& stepLengths);

    double total() const { return lengths_.back(); }
    /// Parameter at the distance `s` from the beginning, for s in [0, total()].
    double parameterAt(double s) const;

private:
    double begin_, step_;
    std::vector<double> lengths_;  // from the beginning to each step's end
};

/// The mean meridian: theta by distance from the whorl, where a step of theta counts as long as it
/// is on average over all phi.
ArcLength meanMeridian(const Ellipsoid& ellipsoid);

/// The row of theta = 90 degrees: phi in [0, 2 pi] by distance from phi = 0. Every other row is the
/// same but sin(theta) times as long.
ArcLength equator(const Ellipsoid& ellipsoid);

/// |dP/dtheta|, the length of a meridian per radian of theta [m].
double meridianSpeed(const Ellipsoid& ellipsoid, EllipsoidAngles at);

/// |dP/dtheta x dP/dphi|, the area per radian of theta and radian of phi [m2].
double areaSpeed(const Ellipsoid& ellipsoid, EllipsoidAngles at);

}  // namespace kushi
