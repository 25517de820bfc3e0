// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "geometry/triangle_tree.h"

#include <vector>

namespace kushi {

/// The triangles of a closed surface that have an outside. The others lie within it: where pieces
/// cut each other or an opening is closed inside another piece. Whoever is inside is as deep as the
/// skin is far. One that cuts through the skin counts as skin.
std::vector<Triangle> skinOf(const TriangleTree& surface, int threads);

}  // namespace kushi
