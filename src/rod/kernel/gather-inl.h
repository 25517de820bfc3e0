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

#include <cstring>
#include <span>

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

// Each lane's numbers one after the other: `to` takes rows.size() floats per lane. Rows are a
// multiple of four.
HWY_INLINE void transpose(std::span<const Lanes> rows, float* to) {
    alignas(64) float fours[4 * Lanes::count];
    for (std::size_t r = 0; r < rows.size(); r += 4) {
        hn::StoreInterleaved4(rows[r].v, rows[r + 1].v, rows[r + 2].v, rows[r + 3].v, Lanes::Tag(),
                              fours);
        for (std::size_t lane = 0; lane < Lanes::count; ++lane)
            std::memcpy(to + lane * rows.size() + r, fours + 4 * lane, 4 * sizeof(float));
    }
}
HWY_INLINE void transpose(std::span<const double> rows, float* to) {
    for (std::size_t r = 0; r < rows.size(); ++r)
        to[r] = static_cast<float>(rows[r]);
}

// The other way: `size` numbers of each lane, from where they lie one after the other. There is
// room for a multiple of four rows.
HWY_INLINE void gatherRows(const float* const* from, std::size_t size, std::span<Lanes> rows) {
    alignas(64) float fours[4 * Lanes::count] = {};
    for (std::size_t r = 0; r < size; r += 4) {
        const std::size_t some = size - r < 4 ? size - r : 4;
        for (std::size_t lane = 0; lane < Lanes::count; ++lane)
            std::memcpy(fours + 4 * lane, from[lane] + r, some * sizeof(float));
        hn::LoadInterleaved4(Lanes::Tag(), fours, rows[r].v, rows[r + 1].v, rows[r + 2].v,
                             rows[r + 3].v);
    }
}
HWY_INLINE void gatherRows(const float* const* from, std::size_t size, std::span<double> rows) {
    for (std::size_t r = 0; r < size; ++r)
        rows[r] = from[0][r];
}

}  // namespace kushi::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#endif
