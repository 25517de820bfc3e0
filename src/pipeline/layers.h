// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <kushi/follicles.h>
#include <kushi/rods.h>

#include <span>
#include <vector>

namespace kushi {

/// How thick the hair is on which strands lie, by the place of their roots.
struct LayerMap {
    std::vector<Layer> cells;  ///< of theta and phi; none: they lie on the skin

    Layer at(EllipsoidAngles root) const;
    /// Of each of some roots; empty if they lie on the skin.
    std::vector<Layer> of(std::span<const EllipsoidAngles> roots) const;
};

/// Hair that grows below a strand on its way down the scalp, from the ellipsoid's pole along the
/// meridian, lies beneath it. With so many hairs to the area as the scalp bears along that way, the
/// pile rises by hairs x section / packing on each metre, up to where no more hair grows.
///
/// follicles  all of the style's, so that a preview lies as the whole does
/// diameter   of the hairs [m]
/// packing    share of the pile that is hair, in (0, 1)
LayerMap layerMapOf(const Ellipsoid& ellipsoid, const Follicles& follicles, double diameter,
                    double packing);

}  // namespace kushi
