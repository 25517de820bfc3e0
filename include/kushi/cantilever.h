// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <kushi/distance_field.h>
#include <kushi/style.h>

#include <span>

namespace kushi {

/// One clamped strand, straight before it is bent.
struct CantileverRod {
    Vec3d root;           ///< m
    Vec3d direction;      ///< unit
    double length = 0;    ///< m, > 0
    double rigidity = 0;  ///< EI [N m2], > 0
    double weight = 0;    ///< w, per unit length [N/m], > 0
};

/// A force that holds a strand's root, with the share that the softened edge of its root range
/// gives.
struct ActiveForce {
    const Force* force = nullptr;
    double rootShare = 1;
};

/// What acts on a strand.
struct CantileverWorld {
    Vec3d gravity = {0, -1, 0};  ///< times the earth's
    std::span<const ActiveForce> forces = {};
    Vec3d tipLoad;                          ///< dead load at the last node [N]
    const Ellipsoid* obstacle = nullptr;    ///< kept outside of; none if null
    const DistanceField* solids = nullptr;  ///< kept outside of as well; none if null
    int avoidanceSteps = 4;
};

/// Gravity and forces at a place, as a multiple of the hair's own weight.
Vec3d loadAt(const CantileverWorld& world, Vec3d point);

/// Bends a strand in one walk from root to tip (Usami & Anjyo 1992, 2.2, figures 2 to 4).
///
/// Each segment of length d = L/n is a small cantilever: its end moves across its axis by
/// y = M d^2 / (2 EI) (eq. 2) in the two directions normal to it, where M is the mean of the
/// bending moments at the segment's two ends under the loads beyond, taken as if the strand went on
/// straight; then the segment is set back to its length. A segment whose end would lie inside the
/// obstacle is turned out of it (avoid). The walk goes along chords, so that in small deflection it
/// bends half as far as a beam; it reproduces the paper and is no equilibrium.
///
/// nodes  n + 1 of them, n >= 1; overwritten, root first [m]
void bendCantilever(const CantileverRod& rod, const CantileverWorld& world, std::span<Vec3d> nodes);

}  // namespace kushi
