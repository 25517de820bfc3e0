// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "geometry/axes.h"
#include "trace/brightness.h"
#include "trace/sampler.h"

#include <kushi/shade.h>

#include <cstddef>
#include <vector>

namespace kushi {

/// A distant light as a disc of even radiance.
struct Disc {
    Axes axes;  ///< z towards its middle
    Rgb radiance;
    float depth = 0;       ///< 1 - cos of half the angle it is seen under
    float solidAngle = 0;  ///< sr

    explicit Disc(const Light& light);
    bool holds(Vec3f direction) const {
        const Vec3f off = direction - axes.z;
        return dot(off, off) < 2 * depth;  // |a - b|^2 = 2 - 2 cos
    }
    /// Evenly over its solid angle.
    Vec3f sample(Pair random) const;
};

/// All light that comes from far away. A matt white surface square to a light gets its colour.
struct Sky {
    Rgb dome;
    std::vector<Disc> discs;
    float power = 0;  ///< luminance of all discs, times their solid angles

    explicit Sky(const Lights& lights);
};

}  // namespace kushi
