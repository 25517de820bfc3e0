// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <kushi/head.h>
#include <kushi/style.h>

namespace kushi {

// Hair at rest on the ellipsoid of the built-in head.
inline Style headOfHair(int count, int segments, double length) {
    Style style;
    style.headCollides = false;
    style.solver = {Method::Equilibrium, segments, 1, 4};
    style.parts.resize(1);
    Part& part = style.parts[0];
    part.name = "hair";
    part.scalp.ellipsoid = headEllipsoid();
    part.scalp.count = count;
    part.scalp.regions = {{{0, radians(80)}, {}}};
    part.hair.length = length;
    return style;
}

}  // namespace kushi
