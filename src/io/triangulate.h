// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "io/faces.h"

#include <cstddef>

namespace kushi {

/// No polygon has more corners: cutting one costs the square of their number.
inline constexpr std::size_t mostCorners = 1000;

/// Appends a polygon, given by its corners (3 to mostCorners, indices of faces.points), as
/// triangles that turn the same way round. It need be neither convex nor quite flat.
void addPolygon(Faces& faces, std::vector<Faces::Corner> polygon);

}  // namespace kushi
