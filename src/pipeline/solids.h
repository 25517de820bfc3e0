// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <kushi/style.h>

#include <vector>

namespace kushi {

/// Coulomb's coefficients of what solidsOf() is made of: the head, if it collides, and the
/// colliders.
std::vector<float> frictionsOf(const Style& style);

}  // namespace kushi
