// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <kushi/style.h>

#include <vector>

namespace kushi {

/// What solidsOf() is made of, in its order: the head, if it collides, and the colliders.
std::vector<Collider> headAndColliders(const Style& style);

}  // namespace kushi
