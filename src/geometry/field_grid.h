// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <kushi/distance_field.h>

namespace kushi {

/// A spacing that is asked for may take so many samples.
inline constexpr double mostSamples = 256e6;

/// The grid for solids, with no samples yet; empty without triangles. Its problems are those of
/// distanceFieldOf().
Result<DistanceField> gridFor(std::span<const Solid> solids, const DistanceFieldOptions& options);

}  // namespace kushi
