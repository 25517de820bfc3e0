// SPDX-License-Identifier: Apache-2.0
//
// Functions of many floats side by side.
#if defined(KUSHI_SHADING_FUNCTIONS_INL_H) == defined(HWY_TARGET_TOGGLE)
#ifdef KUSHI_SHADING_FUNCTIONS_INL_H
#undef KUSHI_SHADING_FUNCTIONS_INL_H
#else
#define KUSHI_SHADING_FUNCTIONS_INL_H
#endif

#include "core/lanes-inl.h"

HWY_BEFORE_NAMESPACE();
namespace kushi::HWY_NAMESPACE {

// exp(x) to 3e-7 for x in [-80, 80]; beyond it is that of the nearest end.
HWY_INLINE Lanes exponential(Lanes x) {
    x = least(most(x, Lanes(-80)), Lanes(80));
    // 2^(n + f), n rounded by the loss of what lies behind the point.
    const Lanes shift(0x1.8p23F);
    const Lanes whole = (x * Lanes(1.44269504F) + shift) - shift;
    const Lanes f = (x - whole * Lanes(0.693359375F)) + whole * Lanes(2.12194440e-4F);
    // Taylor's, over [-ln 2 / 2, ln 2 / 2].
    Lanes power(1.0F / 720);
    power = power * f + Lanes(1.0F / 120);
    power = power * f + Lanes(1.0F / 24);
    power = power * f + Lanes(1.0F / 6);
    power = power * f + Lanes(0.5F);
    power = power * f + Lanes(1);
    power = power * f + Lanes(1);
    const hn::RebindToSigned<Lanes::Tag> whole32;
    const auto exponent = hn::ShiftLeft<23>(hn::ConvertTo(whole32, whole.v));
    return Lanes(hn::BitCast(Lanes::Tag(), hn::Add(hn::BitCast(whole32, power.v), exponent)));
}

// The angle in [0, pi] to 7e-5 rad (Abramowitz and Stegun 4.4.45); x in [-1, 1].
HWY_INLINE Lanes arcCosine(Lanes x) {
    const Lanes size = magnitude(x);
    const Lanes series =
        Lanes(1.5707288F) +
        size * (Lanes(-0.2121144F) + size * (Lanes(0.0742610F) + size * Lanes(-0.0187293F)));
    const Lanes angle = squareRoot(most(Lanes(1) - size, Lanes(0))) * series;
    return select(x < Lanes(0), Lanes(3.14159265F) - angle, angle);
}

}  // namespace kushi::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#endif
