// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "contact/density.h"

#include <functional>

namespace kushi {

/// Where hair that lies too closely must go so that none does: the ways by which its excess spreads
/// like a heap of sand, no farther than it takes.
///
/// Ways fall along a potential: of those >= 0 whose Laplacian takes away all that is too much, the
/// smallest (the odometer of the divisible sandpile: Levine and Peres, "Strong spherical
/// asymptotics for rotor-router aggregation and the divisible sandpile", Potential Analysis 30,
/// 2009).
class Spreading {
public:
    /// packing  that hair may have, > 0
    /// inside   whether hair may not go to a place [m]
    Spreading(const Density& density, float packing, const std::function<bool(Vec3f)>& inside);

    /// Of hair at a place [m].
    Vec3f way(Vec3f place) const;

private:
    Voxels voxels_;
    std::vector<Vec3f> ways_;            // at the voxels' middles
    std::vector<std::uint8_t> spreads_;  // whether there are any around, by the lowest corner
};

}  // namespace kushi
