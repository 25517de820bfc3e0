// SPDX-License-Identifier: Apache-2.0
//
// Usami & Anjyo's walk (cantilever.cpp) on strands side by side. Avoidance takes one turn or
// another, so that the last digit of a number may show: only operations that IEEE rounds alike are
// used, so that every processor gives the same bytes.
#include "core/lane_targets.h"
#include "rod/walk_batch.h"

#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "rod/walk_lanes.cpp"
// Highway's file compiles this one again for each target: it comes before the kernels.
// clang-format off
#include <hwy/foreach_target.h>
#include "rod/kernel/walk-inl.h"
// clang-format on

HWY_BEFORE_NAMESPACE();
namespace kushi::HWY_NAMESPACE {

void walkLanesHere(const WalkBatch& batch) {
    Walk walk(batch);
    for (std::size_t i = batch.begin; i < batch.end; i += Lanes::count)
        walk.bend(i, std::min(i + Lanes::count, batch.end));
}

}  // namespace kushi::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#if HWY_ONCE
namespace kushi {

HWY_EXPORT(walkLanesHere);

void walkLanes(const WalkBatch& batch) {
    HWY_DYNAMIC_DISPATCH(walkLanesHere)(batch);
}

}  // namespace kushi
#endif
