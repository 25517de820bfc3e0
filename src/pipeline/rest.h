// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <kushi/follicles.h>
#include <kushi/rods.h>

#include <vector>

namespace kushi {

/// A part's strands at rest, after its cuts, strand by strand in the order of the follicles.
struct RestedPart {
    std::vector<Vec3f> nodes;                  ///< visible ones [m]
    std::vector<std::uint32_t> offsets = {0};  ///< of each follicle's; none where it has no hair
    double maxResidual = 0;                    ///< moments over EI/L + w L^2/2
    std::size_t unsettled = 0;
};

/// Settles a part's strands by true equilibrium, and cuts them: a cut that settles shortens the
/// strands it meets and brings them to rest anew.
///
/// Refuses segments in which the natural shape turns by more than 2.2 rad.
Result<RestedPart> restPart(const Style& style, const Part& part, const Follicles& follicles,
                            int segments, int threads);

}  // namespace kushi
