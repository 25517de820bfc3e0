// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <kushi/rods.h>
#include <kushi/style.h>

#include <span>

namespace kushi {

/// What acts on all the hair that a part grows; all of it belongs to the arguments.
///
/// solids     null: none
/// frictions  of the solids
RodWorld worldOf(const Style& style, const Part& part, const DistanceField* solids,
                 std::span<const float> frictions);

}  // namespace kushi
