// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "pipeline/holding.h"

#include <kushi/style.h>

#include <functional>

namespace kushi {

/// A part's groom at rest after its cuts.
struct GroomPart {
    Strands strands;  ///< what can be seen; with all the attributes that the groom had
    Holding holding;
    double maxResidual = 0;  ///< moments over EI/L + w L^2/2
    std::size_t unsettled = 0;
    double setTime = 0;  ///< ms
};

/// Sets a part's groom, brings it to rest under what the style changes, and cuts it: a cut that
/// settles shortens the strands it meets, and they spring from where they hang to where they rest.
///
/// groom     with keys, diameters and colours
/// progress  told the share done, in [0, 1]; may be empty
Result<GroomPart> settleGroomPart(const Style& style, const Part& part, const Strands& groom,
                                  int threads, const std::function<void(double)>& progress);

}  // namespace kushi
