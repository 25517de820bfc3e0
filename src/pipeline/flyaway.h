// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <kushi/style.h>

#include <cstdint>
#include <span>

namespace kushi {

/// Whether a strand is one of those that stand off, by its key alone.
bool isFlyaway(const Flyaway& flyaway, std::uint64_t key);

/// Bends a strand away from where it lies: outwards, and less so to the sides, in a slow random
/// swing that grows from nothing after the first segment to 0.2 to 1.8 of the distance at the tip,
/// but no more than a third of the length. It becomes shorter by up to 0.3.
///
/// middle  of the head [m], away from which is outwards; of hair below it, horizontally
/// nodes   root first [m]; two or more
void flyAway(const Flyaway& flyaway, std::uint64_t key, Vec3d middle, std::span<Vec3f> nodes);

}  // namespace kushi
