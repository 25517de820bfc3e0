// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "geometry/triangle.h"

#include <kushi/mesh.h>

#include <vector>

namespace kushi {

/// A mesh as triangles that close: every place off them is wound around a whole number of times,
/// and 1 is inside. Vertices at the same place count as one; triangles without three of them, and
/// the repetition of a triangle, are left out. Triangles that share an edge with one other are made
/// to face alike and are a piece; a piece that faces inwards is turned.
std::vector<Triangle> closedSurface(const Mesh& mesh);

}  // namespace kushi
