// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "pipeline/holding.h"

#include <kushi/style.h>

#include <functional>
#include <span>

namespace kushi {

/// A part's groom at rest after its cuts.
struct GroomPart {
    Strands strands;  ///< what can be seen; with all the attributes that the groom had
    Holding holding;
    double maxResidual = 0;  ///< moments over EI/L + w L^2/2
    std::size_t unsettled = 0;
    std::size_t pushedOut = 0;  ///< turned out of solids before it was set
    std::size_t stuck = 0;      ///< still too near to them at the end
    double setTime = 0;         ///< ms
};

/// Turns a part's groom out of solids, sets it there, brings it to rest against them under what the
/// style changes, and cuts it: a cut that settles shortens the strands it meets, and they spring
/// from where they hang to where they rest.
///
/// groom     with keys, diameters and colours
/// solids    null: none
/// frictions of the solids
/// progress  told the share done, in [0, 1]; may be empty
Result<GroomPart> settleGroomPart(const Style& style, const Part& part, Strands groom,
                                  const DistanceField* solids, std::span<const float> frictions,
                                  int threads, const std::function<void(double)>& progress);

}  // namespace kushi
