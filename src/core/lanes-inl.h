// SPDX-License-Identifier: Apache-2.0
//
// The number the kernels compute with: either a double, for the reference, or as many floats as a
// register of the processor holds, a strand or a node in each. The kernels are written once, for
// both.
//
// Compiled once for every instruction set (Highway's foreach_target.h), so no include guard.
#if defined(KUSHI_CORE_LANES_INL_H) == defined(HWY_TARGET_TOGGLE)
#ifdef KUSHI_CORE_LANES_INL_H
#undef KUSHI_CORE_LANES_INL_H
#else
#define KUSHI_CORE_LANES_INL_H
#endif

#include <cmath>
#include <cstdint>
#include <span>

#include <hwy/aligned_allocator.h>
#include <hwy/highway.h>

HWY_BEFORE_NAMESPACE();
namespace kushi::HWY_NAMESPACE {

namespace hn = hwy::HWY_NAMESPACE;

// A float for each of several strands.
struct Lanes {
    using Tag = hn::CappedTag<float, 16>;
    using Scalar = float;
    static constexpr std::size_t count = hn::MaxLanes(Tag());

    hn::Vec<Tag> v;

    Lanes() = default;
    HWY_INLINE Lanes(float x) : v(hn::Set(Tag(), x)) {}  // NOLINT: a number is one for all lanes
    HWY_INLINE explicit Lanes(hn::Vec<Tag> x) : v(x) {}

    HWY_INLINE friend Lanes operator+(Lanes a, Lanes b) { return Lanes(hn::Add(a.v, b.v)); }
    HWY_INLINE friend Lanes operator-(Lanes a, Lanes b) { return Lanes(hn::Sub(a.v, b.v)); }
    HWY_INLINE friend Lanes operator*(Lanes a, Lanes b) { return Lanes(hn::Mul(a.v, b.v)); }
    HWY_INLINE friend Lanes operator/(Lanes a, Lanes b) { return Lanes(hn::Div(a.v, b.v)); }
    HWY_INLINE Lanes operator-() const { return Lanes(hn::Neg(v)); }
    HWY_INLINE Lanes& operator+=(Lanes b) { return *this = *this + b; }
    HWY_INLINE Lanes& operator-=(Lanes b) { return *this = *this - b; }
};

struct LaneMask {
    hn::Mask<Lanes::Tag> m;

    HWY_INLINE friend LaneMask operator&(LaneMask a, LaneMask b) { return {hn::And(a.m, b.m)}; }
    HWY_INLINE friend LaneMask operator|(LaneMask a, LaneMask b) { return {hn::Or(a.m, b.m)}; }
    HWY_INLINE LaneMask operator!() const { return {hn::Not(m)}; }
};

HWY_INLINE LaneMask operator<(Lanes a, Lanes b) {
    return {hn::Lt(a.v, b.v)};
}
HWY_INLINE LaneMask operator>(Lanes a, Lanes b) {
    return {hn::Gt(a.v, b.v)};
}
HWY_INLINE LaneMask operator<=(Lanes a, Lanes b) {
    return {hn::Le(a.v, b.v)};
}
HWY_INLINE LaneMask operator>=(Lanes a, Lanes b) {
    return {hn::Ge(a.v, b.v)};
}

HWY_INLINE Lanes select(LaneMask which, Lanes yes, Lanes no) {
    return Lanes(hn::IfThenElse(which.m, yes.v, no.v));
}
HWY_INLINE bool any(LaneMask which) {
    return !hn::AllFalse(Lanes::Tag(), which.m);
}
HWY_INLINE std::size_t count(LaneMask which) {
    return hn::CountTrue(Lanes::Tag(), which.m);
}
HWY_INLINE Lanes squareRoot(Lanes x) {
    return Lanes(hn::Sqrt(x.v));
}
// By the processor's estimate and one step of Newton's method: within an ulp or two, and several
// times as fast as a division or a root. Only AVX-512 estimates 14 bits; from 12, moments keep an
// error near the tolerance, and from 8 or 9 (NEON, what Highway emulates) nothing comes to rest.
#if HWY_ARCH_X86 && HWY_TARGET <= HWY_AVX3
HWY_INLINE Lanes reciprocal(Lanes x) {
    const Lanes guess(hn::ApproximateReciprocal(x.v));
    return guess * (Lanes(2.0F) - x * guess);
}
HWY_INLINE Lanes inverseRoot(Lanes x) {
    const Lanes guess(hn::ApproximateReciprocalSqrt(x.v));
    return guess * (Lanes(1.5F) - Lanes(0.5F) * x * guess * guess);
}
#else
HWY_INLINE Lanes reciprocal(Lanes x) {
    return Lanes(1) / x;
}
HWY_INLINE Lanes inverseRoot(Lanes x) {
    return Lanes(1) / squareRoot(x);
}
#endif
HWY_INLINE Lanes magnitude(Lanes x) {
    return Lanes(hn::Abs(x.v));
}
HWY_INLINE Lanes least(Lanes a, Lanes b) {
    return Lanes(hn::Min(a.v, b.v));
}
HWY_INLINE Lanes most(Lanes a, Lanes b) {
    return Lanes(hn::Max(a.v, b.v));
}
HWY_INLINE Lanes withSignOf(Lanes size, Lanes sign) {
    return Lanes(hn::CopySign(size.v, sign.v));
}
HWY_INLINE Lanes loadLanes(const float* from, Lanes /*kind*/) {
    return Lanes(hn::LoadU(Lanes::Tag(), from));
}
HWY_INLINE void storeLanes(Lanes x, float* to) {
    hn::StoreU(x.v, Lanes::Tag(), to);
}
HWY_INLINE void storeMask(LaneMask which, float* to) {
    storeLanes(select(which, Lanes(1), Lanes(0)), to);
}

// The same for one strand in double precision.
HWY_INLINE double select(bool which, double yes, double no) {
    return which ? yes : no;
}
HWY_INLINE bool any(bool which) {
    return which;
}
HWY_INLINE std::size_t count(bool which) {
    return which ? 1 : 0;
}
HWY_INLINE double squareRoot(double x) {
    return std::sqrt(x);
}
HWY_INLINE double reciprocal(double x) {
    return 1 / x;
}
HWY_INLINE double inverseRoot(double x) {
    return 1 / std::sqrt(x);
}
HWY_INLINE double magnitude(double x) {
    return std::abs(x);
}
HWY_INLINE double least(double a, double b) {
    return a < b ? a : b;
}
HWY_INLINE double most(double a, double b) {
    return a > b ? a : b;
}
HWY_INLINE double withSignOf(double size, double sign) {
    return std::copysign(size, sign);
}
HWY_INLINE double loadLanes(const double* from, double /*kind*/) {
    return *from;
}
HWY_INLINE void storeLanes(double x, double* to) {
    *to = x;
}
HWY_INLINE void storeMask(bool which, double* to) {
    *to = which ? 1 : 0;
}

template <class V>
struct LaneTraits {
    using Scalar = typename V::Scalar;
    using Mask = LaneMask;
    static constexpr std::size_t count = V::count;
};
template <>
struct LaneTraits<double> {
    using Scalar = double;
    using Mask = bool;
    static constexpr std::size_t count = 1;
};
template <class V>
using MaskOf = typename LaneTraits<V>::Mask;
template <class V>
using ScalarOf = typename LaneTraits<V>::Scalar;

// Room for some of a type made of lanes, aligned as they need; not initialized.
template <class T>
class Room {
public:
    explicit Room(std::size_t count)
        : bytes_(hwy::AllocateAligned<std::uint8_t>(count * sizeof(T) + 1)), count_(count) {}

    std::span<T> items() const { return {reinterpret_cast<T*>(bytes_.get()), count_}; }

private:
    hwy::AlignedFreeUniquePtr<std::uint8_t[]> bytes_;
    std::size_t count_;
};

// A number that floats cannot hold exactly, as exact as V can.
template <class V>
HWY_INLINE V number(double x) {
    return V(static_cast<ScalarOf<V>>(x));
}

// asin(x) / x as a function of s = x^2 in [0, 1].
HWY_INLINE Lanes arcsineSeries(Lanes s) {
    // Taylor's; s <= 0.25.
    Lanes p(0.0111496F);
    p = p * s + Lanes(0.0139648F);
    p = p * s + Lanes(0.0173528F);
    p = p * s + Lanes(0.0223722F);
    p = p * s + Lanes(0.0303819F);
    p = p * s + Lanes(0.0446429F);
    p = p * s + Lanes(0.075F);
    p = p * s + Lanes(0.16666667F);
    return p * s + Lanes(1);
}
HWY_INLINE Lanes arcsineRatio(Lanes s) {
    const LaneMask near = s < Lanes(0.25F);
    if (!any(!near)) return arcsineSeries(s);
    // asin(x) = pi/2 - 2 asin(sqrt((1 - x) / 2)).
    const Lanes x = squareRoot(s);
    const Lanes t = select(near, s, Lanes(0.5F) * (Lanes(1) - x));
    const Lanes p = arcsineSeries(t);
    const Lanes far = Lanes(1.5707964F) - Lanes(2) * squareRoot(t) * p;
    return select(near, p, far / most(x, Lanes(0.25F)));
}
HWY_INLINE double arcsineRatio(double s) {
    const double x = std::sqrt(s);
    return x < 1e-4 ? 1 + s / 6 : std::asin(std::min(x, 1.0)) / x;
}

template <class V>
struct SineCosine {
    V sine, cosine;
};

// Of 2 x, for x in [-pi/2, pi/2]; to a few ulp of a float.
template <class V>
HWY_INLINE SineCosine<V> sineCosineOfTwice(V x) {
    const V xx = x * x;
    V s = number<V>(-1.0 / 39916800) * xx + number<V>(1.0 / 362880);
    s = s * xx - number<V>(1.0 / 5040);
    s = s * xx + number<V>(1.0 / 120);
    s = s * xx - number<V>(1.0 / 6);
    s = s * xx * x + x;
    V c = number<V>(1.0 / 479001600) * xx - number<V>(1.0 / 3628800);
    c = c * xx + number<V>(1.0 / 40320);
    c = c * xx - number<V>(1.0 / 720);
    c = c * xx + number<V>(1.0 / 24);
    c = c * xx - V(0.5F);
    c = c * xx + V(1);
    return {V(2) * s * c, V(1) - V(2) * s * s};
}

}  // namespace kushi::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#endif
