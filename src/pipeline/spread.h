// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <kushi/vec.h>

#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

namespace kushi {

/// `count` of some points (all, if there are no more), spread as evenly as they are, ascending.
/// What is taken for a smaller count is also taken for a larger one.
///
/// Points may coincide. They are put on a space-filling curve (Morton 1966), and those taken first
/// whose rank along it comes first in van der Corput's sequence.
std::vector<std::uint32_t> spreadSubset(std::span<const Vec3f> points, std::size_t count);

}  // namespace kushi
