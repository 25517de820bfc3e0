// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "contact/push_out.h"

#include <kushi/push_out.h>

#include <functional>
#include <span>

namespace kushi {

/// How far off solids strands are kept in the end [m]: about as much as their field may be wrong,
/// which is most at the rims of ears.
inline double marginOf(const DistanceField& solids) {
    return 0.3 * static_cast<double>(solids.spacing);
}

/// pushOut() of one strand by marginOf(); root first [m].
Pushed pushOneOut(const DistanceField& solids, std::span<Vec3f> nodes);

/// The same of strands that lie anywhere.
PushOutReport pushAllOut(const DistanceField& solids, std::size_t count,
                         const std::function<std::span<Vec3f>(std::size_t)>& strand, int threads);

}  // namespace kushi
