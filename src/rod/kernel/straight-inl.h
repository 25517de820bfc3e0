// SPDX-License-Identifier: Apache-2.0
//
// A segment of straight, round hair. Under dead loads it never twists, so the unknowns are the unit
// tangents at the nodes. Between the tangents a and b, theta apart, the segment bends by
// EI theta^2 / (2 d), and its chord, of length d, lies along their bisector.
#if defined(KUSHI_ROD_STRAIGHT_INL_H) == defined(HWY_TARGET_TOGGLE)
#ifdef KUSHI_ROD_STRAIGHT_INL_H
#undef KUSHI_ROD_STRAIGHT_INL_H
#else
#define KUSHI_ROD_STRAIGHT_INL_H
#endif

#include "rod/kernel/matrix-inl.h"

HWY_BEFORE_NAMESPACE();
namespace kushi::HWY_NAMESPACE {

// How far to differentiate.
enum class Order { Gradient, Hessian };

// Gradient and Hessian of the energy of one segment in the rotations alpha and beta of its two
// nodes, and how its chord moves with them.
template <class V, int Freedoms>
struct Derivatives {
    Column<V, Freedoms> ga, gb;
    Matrix<V, Freedoms, Freedoms> haa, hab, hbb;  // hab: rows alpha, columns beta
    Matrix<V, 3, Freedoms> a, b;                  // chord = ... + a alpha + b beta
};

template <class V>
struct Straight {
    static constexpr int freedoms = 2;
    using State = V3<V>;  // unit tangent

    struct Segment {
        V length;  // d [m]
        V weight;  // of the segment [N]
        V bend;    // EI / d [N m]
    };

    // Two unit vectors normal to t and to each other (Duff et al. 2017).
    HWY_INLINE static Matrix<V, 3, 2> basis(const V3<V>& t) {
        const V sign = withSignOf(V(1), t[2]);
        const V p = -reciprocal(sign + t[2]);
        const V q = t[0] * t[1] * p;
        return {{{V(1) + sign * t[0] * t[0] * p, q},
                 {sign * q, sign + t[1] * t[1] * p},
                 {-sign * t[0], -t[1]}}};
    }

    HWY_INLINE static V3<V> chord(const Segment& segment, const State& a, const State& b) {
        const V3<V> sum = a + b;
        return (segment.length * inverseRoot(most(dot(sum, sum), V(1e-12F)))) * sum;
    }

    HWY_INLINE static State turned(const State& at, const Column<V, 2>& by) {
        return unit(at + basis(at) * by);
    }

    // (1 - theta cot(theta)) / sin(theta)^2.
    HWY_INLINE static V curvatureRatio(V s, V thetaCot, V rest) {
        const MaskOf<V> small = s < V(0.1F);
        V series = number<V>(640.0 / 693) + s * number<V>(1024.0 / 1001);
        series = number<V>(256.0 / 315) + s * series;
        series = number<V>(24.0 / 35) + s * series;
        series = number<V>(8.0 / 15) + s * series;
        series = number<V>(1.0 / 3) + s * series;
        if (!any(!small)) return series;
        return select(small, series, (V(1) - thetaCot) / (V(4) * most(s, V(1e-3F)) * rest));
    }

    // force  what the segment carries at its end [N]
    template <Order order>
    HWY_INLINE static Derivatives<V, 2> derive(const Segment& segment, const State& a,
                                               const State& b, const V3<V>& force,
                                               bool withChords) {
        const Matrix<V, 3, 2> ea = basis(a);
        const Matrix<V, 3, 2> eb = basis(b);
        const Matrix<V, 2, 3> eat = transposed(ea);
        const Matrix<V, 2, 3> ebt = transposed(eb);
        const Column<V, 2> ab = ebt * a;
        const Column<V, 2> ba = eat * b;
        const Column<V, 2> fa = eat * force;
        const Column<V, 2> fb = ebt * force;

        // theta by half of its sine, exact for small angles; r = theta / sin(theta).
        const V3<V> gap = b - a;
        const V s = least(V(0.25F) * dot(gap, gap), V(0.99999F));
        const V c = V(1) - V(2) * s;
        const V rest = V(1) - s;
        const V root = inverseRoot(rest);
        const V r = arcsineRatio(s) * root;

        // d / |a + b| and 1 / |a + b|^2.
        const V p = segment.length * V(0.5F) * root;
        const V i2 = V(0.25F) * root * root;
        const V3<V> sum = a + b;
        const V along = dot(force, sum);
        const V pull = p * along * i2;
        const V k = segment.bend;

        Derivatives<V, 2> d;
        d.ga = (pull - k * r) * ba - p * fa;
        d.gb = (pull - k * r) * ab - p * fb;
        if constexpr (order == Order::Gradient) return d;

        const V q = curvatureRatio(s, r * c, rest);
        const Matrix<V, 2, 2> ee = eat * eb;
        const V twice = k * q - V(3) * pull * i2;
        const V pi = p * i2;
        const V common = k * r * c - pull * c;
        d.hab = (pull - k * r) * ee + twice * outer(ba, ab) + pi * (outer(fa, ab) + outer(ba, fb));
        d.haa = diagonal<2>(common + p * dot(force, a)) + twice * outer(ba, ba) +
                pi * (outer(fa, ba) + outer(ba, fa));
        d.hbb = diagonal<2>(common + p * dot(force, b)) + twice * outer(ab, ab) +
                pi * (outer(fb, ab) + outer(ab, fb));
        if (withChords) {
            d.a = p * ea - pi * outer(sum, ba);
            d.b = p * eb - pi * outer(sum, ab);
        }
        return d;
    }
};

}  // namespace kushi::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#endif
