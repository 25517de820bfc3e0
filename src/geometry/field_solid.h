// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <kushi/distance_field.h>

namespace kushi {

/// Lowers the samples that `solid` is nearer to than what the field holds; if it holds which solid
/// is nearest, that is `index` there.
void addSolid(DistanceField& field, const Solid& solid, std::uint8_t index, int threads);

}  // namespace kushi
