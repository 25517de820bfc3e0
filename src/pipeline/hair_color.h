// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <kushi/style.h>

#include <cstdint>
#include <span>
#include <vector>

namespace kushi {

/// Appends the colour of each node of a strand: the hair's, or white if the strand is one of the
/// grey ones; over it that of the tips, then the highlights that the strand has, then the regrowth;
/// lighter or darker by the strand's share of the variation, and darker over the first 3 cm, where
/// it grows in.
///
/// angles  of the root on the part's ellipsoid
/// nodes   root first [m]
/// colors  linear; one more per node
void appendHairColors(const Part& part, std::uint64_t key, EllipsoidAngles angles,
                      std::span<const Vec3f> nodes, std::vector<Rgb>& colors);

}  // namespace kushi
