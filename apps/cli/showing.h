// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "scene.h"

#include <vector>

namespace kushi {

/// The share of the scalp in [0, 1] that shows through the hair in each of the six named views;
/// empty without a head. Stage `showing`.
std::vector<ScalpShowing> scalpShowing(const Scene& scene, const DrawOptions& options,
                                       StageClock& clock);

}  // namespace kushi
