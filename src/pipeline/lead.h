// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <kushi/vec.h>

#include <span>

namespace kushi {

/// Leads a hanging strand to where springs would draw it, and gives the loads that hold it there:
/// what those pull with when it has followed them, as a stiff string under its own weight does that
/// is clamped at the root. Of first order in the ways; for strands of at least one segment.
///
/// nodes       at rest, root first; moved to where they will be about [m]
/// ways        of each node, to where it is drawn; what is along the strand does not count [m]
/// bendLength  over which hair bends under its weight: (EI / w)^(1/3) [m]
/// strength    of the loads, times what such a string needs
/// loads       of each segment, times its weight: added to
void lead(std::span<Vec3f> nodes, std::span<const Vec3f> ways, float bendLength, float strength,
          std::span<Vec3f> loads);

}  // namespace kushi
