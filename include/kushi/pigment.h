// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <kushi/color.h>

namespace kushi {

/// sigma_a of pigment (d'Eon et al. 2011, the table as in pbrt). Blond is about 0.3, brown 1.3,
/// black 8.
///
/// melanin  concentration, >= 0
/// redness  share of it that is pheomelanin, in [0, 1]
Rgb absorptionOfMelanin(float melanin, float redness);

/// sigma_a with which a whole head of such fibres shows about the given colour in light that comes
/// evenly from everywhere. As Chiang et al. (2016), eq. 9, but no head of hair is darker than what
/// the surface of its fibres reflects, and below that it shows what our path tracer finds.
///
/// color      each channel counts as in [0.025, 0.99]; 0.025 is black
/// azimuthal  beta_n
Rgb absorptionOfColor(Rgb color, double azimuthal);

/// The inverse of absorptionOfColor().
Rgb colorOfAbsorption(Rgb absorption, double azimuthal);

}  // namespace kushi
