// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <kushi/follicles.h>
#include <kushi/rods.h>

#include <cstdint>
#include <vector>

namespace kushi {

/// Length to which a follicle's hair grows [m]: the hair's, varied by the follicle's key.
double grownLength(const Hair& hair, std::uint64_t key);

/// How long a follicle's strand is and how finely it is cut.
struct Sizes {
    std::vector<double> lengths;        ///< m, each > 0
    std::vector<std::size_t> segments;  ///< each >= 1
};

/// Of strands that nobody has cut yet.
Sizes uncut(const Hair& hair, const Follicles& follicles, int segments);

/// The unloaded strands of some follicles, given by their places in `follicles` and in `sizes`:
/// straight along the growth direction, or winding or waving about it.
///
/// grading  node j of n lies at (j/n)^grading of the length
Rods grow(const Part& part, const Follicles& follicles, const Sizes& sizes,
          std::span<const std::uint32_t> which, double grading);

/// Most that the natural shape of these rods turns in one segment [rad].
double largestTurn(const Rods& rods);

}  // namespace kushi
