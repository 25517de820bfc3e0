// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <kushi/style.h>

#include <cstdint>
#include <span>
#include <vector>

namespace kushi {

/// Appends the colour of each node of a strand: the hair's, lighter or darker by the strand's share
/// of the variation, and darker over the first 3 cm, where it grows in.
///
/// nodes   root first [m]
/// colors  linear; one more per node
void appendHairColors(const Hair& hair, std::uint64_t key, std::span<const Vec3f> nodes,
                      std::vector<Rgb>& colors);

}  // namespace kushi
