// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <kushi/style.h>

#include <cstdint>
#include <optional>
#include <span>
#include <vector>

namespace kushi {

/// Where in the spread of a cut's falloff a follicle's strand is cut, in [-1, 1).
double cutPlace(std::uint64_t key);

/// Length of a strand that a cut leaves [m]: 0 where the follicle itself lies below the height,
/// nothing where the cut does not reach the strand.
///
/// nodes  at least two, root first [m]
/// at     of cutPlace(); 1 leaves most
std::optional<double> lengthLeft(const Cut& cut, std::span<const Vec3d> nodes, double at = 0);

/// The same for a strand that a cut takes only a share in (0, 1] of: of the length that would go,
/// that share goes.
std::optional<double> lengthLeft(const Cut& cut, std::span<const Vec3d> nodes, double at,
                                 double share);

/// The first `length` metres of a polyline, ending on the segment where that falls.
std::vector<Vec3d> clipped(std::span<const Vec3d> nodes, double length);

}  // namespace kushi
