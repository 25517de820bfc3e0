// SPDX-License-Identifier: Apache-2.0
//
// The forces of loadAt(), on strands side by side.
#if defined(KUSHI_ROD_WALK_LOADS_INL_H) == defined(HWY_TARGET_TOGGLE)
#ifdef KUSHI_ROD_WALK_LOADS_INL_H
#undef KUSHI_ROD_WALK_LOADS_INL_H
#else
#define KUSHI_ROD_WALK_LOADS_INL_H
#endif

#include "rod/kernel/gather-inl.h"
#include "rod/walk_batch.h"

HWY_BEFORE_NAMESPACE();
namespace kushi::HWY_NAMESPACE {

// A force, and how much of it each strand's root takes.
struct HeldForce {
    const WalkForce* force;
    Lanes strength;
    V3<Lanes> direction;
};

// The share of a force's box at a place.
HWY_INLINE Lanes shareOf(const WalkForce& force, const V3<Lanes>& at) {
    Lanes share(1);
    for (const BoxFace& face : force.faces) {
        const Lanes inside = Lanes(face.side) * (at[face.axis] - Lanes(face.place));
        if (force.width <= 0) {
            share = select(inside >= Lanes(0), share, Lanes(0));
        } else {
            const Lanes t =
                least(most(inside / Lanes(force.width) + Lanes(0.5F), Lanes(0)), Lanes(1));
            share = share * (t * t * (Lanes(3) - Lanes(2) * t));
        }
    }
    return share;
}

HWY_INLINE V3<Lanes> pullAt(const HeldForce& held, const V3<Lanes>& at) {
    const Lanes pull = held.strength * shareOf(*held.force, at);
    if (!held.force->radial) return pull * held.direction;
    const Lanes square = at[0] * at[0] + at[2] * at[2];
    const Lanes scale = select(square > Lanes(0), pull / squareRoot(square), Lanes(0));
    return {scale * at[0], Lanes(0), scale * at[2]};
}

}  // namespace kushi::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#endif
