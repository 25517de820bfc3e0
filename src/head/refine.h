// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "head/polygonise.h"

#include <kushi/mesh.h>

#include <functional>

namespace kushi {

/// How fine a surface shall be; lengths in the unit of the field.
struct Fineness {
    double maxTurn = 0.2;                  ///< between the normals at the ends of an edge [rad]
    double maxError = 0.01;                ///< of the field at an edge's middle
    std::function<double(Vec3d)> minEdge;  ///< at a place: no edge is split into shorter ones
    int rounds = 3;                        ///< of splitting, each about halving the edges
};

/// Splits edges where the surface bends, without leaving gaps, then evens the triangles out.
void refine(const Field& field, const Fineness& fineness, HalfSurface& half);

/// Both halves as a closed mesh, exactly mirrored in z; normals along the field's gradient, taken
/// over the length of the shortest edges.
Mesh mirrored(const Field& field, const Fineness& fineness, const HalfSurface& half);

}  // namespace kushi
