// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <kushi/style.h>

#include <array>
#include <vector>

namespace kushi {

/// One straight, clamped rod bent in its vertical plane: the bench rig of the solvers.
struct PlanarRod {
    double length = 0;      ///< m, > 0
    double rigidity = 0;    ///< EI [N m2], > 0
    double weight = 0;      ///< per unit length [N/m], >= 0
    double clampAngle = 0;  ///< of the root above the horizontal [rad]
    double tipLoad = 0;     ///< dead load hung on the tip [N], >= 0
};

struct PlanarShape {
    std::vector<std::array<double, 2>> nodes;  ///< x forward, y up [m]; root first, at the origin
    /// Largest imbalance of moments relative to EI/L + w L^2/2 + P L.
    double residual = 0;
};

/// The rod's shape with n >= 1 equal segments.
///
/// Equilibrium: the stationary point of bending + gravity energy over the tangent angle at each
/// node, with chords along the mean of their two tangents and the weight of each segment at its
/// middle; the one reached from the straight rod as the loads grow from zero. An upright rod that
/// buckles falls forward. Cantilever: bendCantilever (Usami & Anjyo 1992), whose residual tells how
/// far it is from rest.
PlanarShape bendPlanarRod(const PlanarRod& rod, int segments, Method method);

}  // namespace kushi
