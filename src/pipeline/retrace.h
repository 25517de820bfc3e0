// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <kushi/vec.h>

#include <span>

namespace kushi {

/// Walks from a strand's root, segment by segment, each as long as it was times `scale` and in the
/// direction of that of `wanted`.
///
/// nodes   root first [m]; as they were, then as walked
/// wanted  as many nodes [m]
void retrace(std::span<const Vec3d> wanted, double scale, std::span<Vec3f> nodes);

}  // namespace kushi
