// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <kushi/vec.h>

#include <span>

namespace kushi {

/// Walks from a strand's root, segment by segment, each in the direction of that of `wanted` and as
/// long as it was, times `scale` but for the first, which comes out of the skin.
///
/// nodes   root first [m]; as they were, then as walked
/// wanted  as many nodes [m]
void retrace(std::span<const Vec3d> wanted, double scale, std::span<Vec3f> nodes);

}  // namespace kushi
