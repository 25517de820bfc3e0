// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <kushi/vec.h>

namespace kushi {

/// Parametric angles on an ellipsoid [rad]: x' = a sin(theta) cos(phi), y' = b cos(theta),
/// z' = c sin(theta) sin(phi).
struct EllipsoidAngles {
    double theta = 0;  ///< from y' (the whorl), in [0, pi]
    double phi = 0;    ///< about y' from x' (front) towards +z (the person's right), in [-pi, pi)
};

/// The surface from which hair grows and which it avoids (Usami & Anjyo 1992, 2.3, figure 5).
struct Ellipsoid {
    Vec3d center;        ///< m
    Vec3d semiAxes;      ///< a, b, c along x', y', z' [m], each > 0
    double rotateZ = 0;  ///< about z [rad]; > 0 tips the y' axis backwards, towards -x

    /// World point to the primed axes, centred.
    Vec3d toLocal(Vec3d world) const;
    /// Direction from the primed axes to the world.
    Vec3d toWorldDirection(Vec3d local) const;

    Vec3d point(EllipsoidAngles at) const;
    /// Angles of the surface point on the ray from the centre through the scaled `world`.
    EllipsoidAngles angles(Vec3d world) const;

    /// (x'/a)^2 + (y'/b)^2 + (z'/c)^2 - 1: negative inside, 0 on the surface, no unit.
    double implicit(Vec3d world) const;
    /// Unit outward normal of the level set of implicit() through `world`; +y at the centre.
    Vec3d normal(Vec3d world) const;
    /// How deep `world` lies below the surface: the distance to its nearest point [m]; 0 outside.
    double depth(Vec3d world) const;
};

}  // namespace kushi
