// SPDX-License-Identifier: Apache-2.0
//
// A segment of any Kirchhoff rod: bending, twist and natural curvature. The unknowns are unit
// quaternions at the nodes, a rotation of the body's axes (d1, d2 across, d3 along) into the
// world's. With a and b at the segment's ends and conj(a) b = (w, v), the strain is
// u = (2 / d) v asin(|v|) / |v|; the chord is that of the natural helix, rigid in the middle frame
// (a + b) / |a + b|. Where the rotation between two nodes passes half a turn, w is negative and
// the angle goes on beyond pi.
#if defined(KUSHI_ROD_CURLY_INL_H) == defined(HWY_TARGET_TOGGLE)
#ifdef KUSHI_ROD_CURLY_INL_H
#undef KUSHI_ROD_CURLY_INL_H
#else
#define KUSHI_ROD_CURLY_INL_H
#endif

#include "rod/kernel/straight-inl.h"

#include <numbers>

HWY_BEFORE_NAMESPACE();
namespace kushi::HWY_NAMESPACE {

template <class V>
struct Quaternion {
    V w;
    V3<V> v;
};

template <class V>
HWY_INLINE Quaternion<V> select(MaskOf<V> which, const Quaternion<V>& yes,
                                const Quaternion<V>& no) {
    return {select(which, yes.w, no.w), select<V, 3>(which, yes.v, no.v)};
}

template <class V>
HWY_INLINE Quaternion<V> product(const Quaternion<V>& p, const Quaternion<V>& q) {
    return {p.w * q.w - dot(p.v, q.v), p.w * q.v + q.w * p.v + cross(p.v, q.v)};
}

template <class V>
HWY_INLINE Quaternion<V> unitQuaternion(const Quaternion<V>& q) {
    const V scale = inverseRoot(most(q.w * q.w + dot(q.v, q.v), V(1e-12F)));
    return {scale * q.w, scale * q.v};
}

template <class V>
HWY_INLINE Matrix<V, 3, 3> rotation(const Quaternion<V>& q) {
    const V two(2);
    const V x = q.v[0];
    const V y = q.v[1];
    const V z = q.v[2];
    return {{{V(1) - two * (y * y + z * z), two * (x * y - q.w * z), two * (x * z + q.w * y)},
             {two * (x * y + q.w * z), V(1) - two * (x * x + z * z), two * (y * z - q.w * x)},
             {two * (x * z - q.w * y), two * (y * z + q.w * x), V(1) - two * (x * x + y * y)}}};
}

template <class V>
struct Curly {
    static constexpr int freedoms = 3;
    using State = Quaternion<V>;

    struct Segment {
        V length;     // d [m]
        V weight;     // of the segment [N]
        V bend;       // EI / d [N m]
        V twist;      // GJ / d [N m]
        V3<V> rest;   // natural strain times d, in body axes
        V3<V> chord;  // [m]
    };

    HWY_INLINE static Quaternion<V> between(const State& a, const State& b) {
        return {a.w * b.w + dot(a.v, b.v), a.w * b.v - b.w * a.v - cross(a.v, b.v)};
    }

    HWY_INLINE static State middle(const State& a, const State& b) {
        return unitQuaternion(Quaternion<V>{a.w + b.w, a.v + b.v});
    }

    HWY_INLINE static V3<V> chord(const Segment& segment, const State& a, const State& b) {
        return rotation(middle(a, b)) * segment.chord;
    }

    HWY_INLINE static State turned(const State& at, const Column<V, 3>& by) {
        return unitQuaternion(product(at, Quaternion<V>{V(1), V(0.5F) * by}));
    }

    HWY_INLINE static V angle(const State& a, const State& b) {
        const Quaternion<V> r = between(a, b);
        const V s = least(dot(r.v, r.v), V(1));
        const V half = squareRoot(s) * arcsineRatio(s);
        return V(2) * select(r.w < V(0), number<V>(std::numbers::pi) - half, half);
    }

    HWY_INLINE static Derivatives<V, 3> derive(const Segment& segment, const State& a,
                                               const State& b, const V3<V>& force,
                                               bool withChords) {
        const Quaternion<V> r = between(a, b);
        const V3<V>& v = r.v;
        const V s = least(dot(v, v), V(0.999999F));

        // h(s) = asin(sqrt(s)) / sqrt(s) and its first two derivatives.
        const V size = squareRoot(most(s, V(1e-12F)));
        const V near = arcsineRatio(s);
        const V h = select(r.w < V(0), number<V>(std::numbers::pi) / size - near, near);
        const V w = withSignOf(most(squareRoot(V(1) - s), V(1e-4F)), r.w);
        const MaskOf<V> small = (s < V(0.03F)) & (r.w > V(0));
        const V safe = most(s, V(1e-6F));
        const V h1 = select(
            small,
            number<V>(1.0 / 6) + s * (number<V>(0.15) + s * (number<V>(15.0 / 112) +
                                                             s * (number<V>(35.0 / 288) +
                                                                  s * number<V>(315.0 / 2816)))),
            (V(1) / w - h) / (V(2) * safe));
        const V h2 = select(
            small,
            number<V>(0.15) + s * (number<V>(15.0 / 56) +
                                   s * (number<V>(35.0 / 96) +
                                        s * (number<V>(315.0 / 704) + s * number<V>(0.52246094)))),
            (V(1) / (V(2) * w * w * w) - V(3) * h1) / (V(2) * safe));

        // Strains times d, and moments.
        const V3<V> strain = (V(2) * h) * v;
        const V3<V> gap = strain - segment.rest;
        const V3<V> moment = {segment.bend * gap[0], segment.bend * gap[1], segment.twist * gap[2]};
        const V mv = dot(moment, v);
        const V3<V> n = V(2) * (h * moment + (V(2) * h1 * mv) * v);
        Matrix<V, 3, 3> jacobian = diagonal<3>(h) + (V(2) * h1) * outer(v, v);
        Matrix<V, 3, 3> scaled = jacobian;
        for (int c = 0; c < 3; ++c) {
            scaled(0, c) = segment.bend * jacobian(0, c);
            scaled(1, c) = segment.bend * jacobian(1, c);
            scaled(2, c) = segment.twist * jacobian(2, c);
        }
        const Matrix<V, 3, 3> hv = V(4) * (jacobian * scaled) +
                                   (V(4) * h1) * (outer(moment, v) + outer(v, moment)) +
                                   diagonal<3>(V(4) * h1 * mv) + (V(8) * h2 * mv) * outer(v, v);

        // c = (w + [v]x) / 2 carries a rotation of b into v, its transpose one of a, negated.
        const Matrix<V, 3, 3> cv = V(0.5F) * (diagonal<3>(r.w) + crossMatrix(v));
        const Matrix<V, 3, 3> cvt = transposed(cv);
        const V nv = V(0.25F) * dot(n, v);
        Derivatives<V, 3> d;
        d.gb = cvt * n;
        d.ga = V(-1) * (cv * n);
        d.hbb = cvt * hv * cv - diagonal<3>(nv);
        d.haa = cv * hv * cvt - diagonal<3>(nv);
        d.hab = V(0.25F) * (outer(v, n) + outer(n, v) + r.w * crossMatrix(n)) - diagonal<3>(nv) -
                cv * hv * cv;

        // The load on the chord.
        const Matrix<V, 3, 3> frame = rotation(middle(a, b));
        const V3<V> f = transposed(frame) * force;
        const V3<V>& chord = segment.chord;
        const V3<V> g = cross(f, chord);
        const Matrix<V, 3, 3> hm =
            diagonal<3>(dot(f, chord)) - V(0.5F) * (outer(chord, f) + outer(f, chord));
        const V half = V(1) + r.w;
        const V3<V> tau = (V(1) / select(magnitude(half) > V(1e-6F), half, V(1e-6F))) * v;
        const Matrix<V, 3, 3> dm = V(0.5F) * (diagonal<3>(V(1)) + crossMatrix(tau));
        const Matrix<V, 3, 3> dmt = transposed(dm);
        const V3<V> turn = cross(g, tau);
        const V3<V> p = g - turn;
        const V3<V> q = g + turn;
        const V gt = V(0.25F) * dot(g, tau);
        d.gb = d.gb + dmt * g;
        d.ga = d.ga + dm * g;
        d.hbb =
            d.hbb + dmt * hm * dm - diagonal<3>(gt) + V(0.125F) * (outer(q, tau) + outer(tau, q));
        d.haa =
            d.haa + dm * hm * dmt + diagonal<3>(gt) - V(0.125F) * (outer(p, tau) + outer(tau, p));
        d.hab = d.hab + dm * hm * dm - V(0.125F) * (outer(tau, q) - outer(p, tau));
        if (withChords) {
            const Matrix<V, 3, 3> moves = V(-1) * (frame * crossMatrix(chord));
            d.a = moves * dmt;
            d.b = moves * dm;
        }
        return d;
    }
};

}  // namespace kushi::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#endif
