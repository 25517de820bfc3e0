// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <kushi/ellipsoid.h>

#include <span>

namespace kushi {

/// Depth of the deepest point of a strand inside an ellipsoid [m], of 8 points on each segment (its
/// first end and 7 more) and the tip.
double deepestPoint(const Ellipsoid& ellipsoid, std::span<const Vec3f> nodes);

}  // namespace kushi
