// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <kushi/distance_field.h>
#include <kushi/rest_shape.h>

#include <cstddef>
#include <vector>

namespace kushi {

/// A groom set as hair that lies on solids.
struct OutsideGroom {
    /// Each strand is clamped where it has come out of the solids, and its rod begins there; the
    /// nodes before go with that place, and stay. One that never comes out is all clamp.
    SetGroom set;
    /// For RodWorld::layers: solids push a strand from where it lies nearest to them, so that they
    /// do not where it lies. Empty without solids.
    std::vector<Layer> skins;
    std::size_t pushedOut = 0;  ///< strands that lay in the solids
};

/// Turns a groom out of solids, by pushOut(), and sets it there at rest under `world`, of `hair` as
/// materialsOf() has it.
///
/// solids  null: none
Result<OutsideGroom> setOutside(const DistanceField* solids, Strands& groom, const Hair& hair,
                                const RodWorld& world, int threads);

}  // namespace kushi
