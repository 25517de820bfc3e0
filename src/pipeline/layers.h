// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <kushi/follicles.h>
#include <kushi/rods.h>

#include <vector>

namespace kushi {

/// How thick the hair is on which each follicle's strand lies: hair that grows below it on its way
/// down the scalp, from the ellipsoid's pole along the meridian, lies beneath. With so many hairs
/// to the area as the scalp bears along that way, the pile rises by hairs x section / packing on
/// each metre, up to where no more hair grows.
///
/// diameter  of the hairs [m]
/// packing   share of the pile that is hair, in (0, 1)
std::vector<Layer> layersOf(const Ellipsoid& ellipsoid, const Follicles& follicles, double diameter,
                            double packing);

}  // namespace kushi
