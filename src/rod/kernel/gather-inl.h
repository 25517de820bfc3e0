// SPDX-License-Identifier: Apache-2.0
//
// Numbers of many strands, put side by side.
#if defined(KUSHI_ROD_GATHER_INL_H) == defined(HWY_TARGET_TOGGLE)
#ifdef KUSHI_ROD_GATHER_INL_H
#undef KUSHI_ROD_GATHER_INL_H
#else
#define KUSHI_ROD_GATHER_INL_H
#endif

#include "rod/kernel/matrix-inl.h"

#include <kushi/vec.h>

HWY_BEFORE_NAMESPACE();
namespace kushi::HWY_NAMESPACE {

// Number x of every strand side by side: V of lane -> value.
template <class V, class Value>
HWY_INLINE V gather(const Value& value) {
    alignas(64) ScalarOf<V> lanes[LaneTraits<V>::count];
    for (std::size_t lane = 0; lane < LaneTraits<V>::count; ++lane)
        lanes[lane] = static_cast<ScalarOf<V>>(value(lane));
    return loadLanes(lanes, V());
}

template <class V, class Value>
HWY_INLINE V3<V> gatherVector(const Value& value) {
    alignas(64) ScalarOf<V> lanes[3][LaneTraits<V>::count];
    for (std::size_t lane = 0; lane < LaneTraits<V>::count; ++lane) {
        const auto v = value(lane);
        lanes[0][lane] = static_cast<ScalarOf<V>>(v.x);
        lanes[1][lane] = static_cast<ScalarOf<V>>(v.y);
        lanes[2][lane] = static_cast<ScalarOf<V>>(v.z);
    }
    return {loadLanes(lanes[0], V()), loadLanes(lanes[1], V()), loadLanes(lanes[2], V())};
}

template <class V>
HWY_INLINE V3<V> everywhere(Vec3d v) {
    return {number<V>(v.x), number<V>(v.y), number<V>(v.z)};
}

}  // namespace kushi::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#endif
