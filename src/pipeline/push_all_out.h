// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <kushi/push_out.h>

#include <functional>
#include <span>

namespace kushi {

/// pushOut() of strands that lie anywhere.
PushOutReport pushAllOut(const DistanceField& solids, std::size_t count,
                         const std::function<std::span<Vec3f>(std::size_t)>& strand, int threads);

}  // namespace kushi
