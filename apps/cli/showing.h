// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "scene.h"

#include <optional>

namespace kushi {

/// The largest share of the scalp that shows through the hair, in [0, 1], of the view rendered and
/// the six named ones; nothing without a head. Stage `showing`.
std::optional<double> scalpShowing(const Scene& scene, View view, const DrawOptions& options,
                                   StageClock& clock);

}  // namespace kushi
