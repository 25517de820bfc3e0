// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "rod/polyline_frames.h"

#include <kushi/rods.h>

#include <cstdint>
#include <span>

namespace kushi {

/// What it takes to hold a strand.
struct Hold {
    bool stable = true;  ///< as it is
    double factor = 1;   ///< of EI and GJ, with a quarter to spare; infinite if there is none
};

/// Gives strand `strand` the natural curvature that balances its loads at `frames` (one for each
/// node; chords and lengths are set already) and says whether it holds there. With `stiffen` its
/// EI and GJ are raised until it does.
Hold balance(Rods& rods, const RodWorld& world, std::uint32_t strand,
             std::span<const Rotation> frames, bool stiffen);

}  // namespace kushi
