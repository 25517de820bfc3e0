// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "contact/density.h"

#include <kushi/strands.h>

#include <span>
#include <vector>

namespace kushi {

/// A strand and how thick it is.
struct ThickStrand {
    std::span<const Vec3f> nodes;
    double diameter = 0;  ///< m
};

/// Strands with diameters, as thick as `standFor` of what they are at their roots.
void appendThick(const Strands& strands, double standFor, std::vector<ThickStrand>& all);

/// How much of each voxel of 5 mm is hair. The same from any number of threads.
Density densityOf(std::span<const ThickStrand> strands, const Voxels& voxels, int threads);

/// Voxels for strands and what they may become.
Voxels voxelsFor(std::span<const ThickStrand> strands);

}  // namespace kushi
