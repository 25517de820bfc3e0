// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <kushi/cantilever.h>

#include <vector>

namespace kushi {

/// One follicle of a part and how finely to cut its hair.
struct StrandSite {
    Vec3d root;  ///< m
    EllipsoidAngles angles;
    std::uint64_t key = 0;
};

/// The strand of one follicle at rest, after forces and cuts.
///
/// returns its nodes, root first [m]; none where cuts leave nothing
std::vector<Vec3d> settleStrand(const Style& style, const Part& part, const StrandSite& site,
                                int segments);

}  // namespace kushi
