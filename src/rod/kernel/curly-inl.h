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

    template <Order order>
    HWY_INLINE static Derivatives<V, 3> derive(const Segment& segment, const State& a,
                                               const State& b, const V3<V>& force,
                                               bool withChords) {
        const Quaternion<V> r = between(a, b);
        const V3<V>& v = r.v;
        const V s = least(dot(v, v), V(0.999999F));

        // h(s) = asin(sqrt(s)) / sqrt(s) and its first two derivatives.
        const V near = arcsineRatio(s);
        const MaskOf<V> wide = r.w < V(0);
        const V h =
            any(wide)
                ? select(wide, number<V>(std::numbers::pi) * inverseRoot(most(s, V(1e-12F))) - near,
                         near)
                : near;
        const V inverseW = withSignOf(inverseRoot(most(V(1) - s, V(1e-8F))), r.w);
        const MaskOf<V> small = (s < V(0.03F)) & (r.w > V(0));
        const V safe = V(0.5F) * reciprocal(most(s, V(1e-6F)));
        const V h1 = select(
            small,
            number<V>(1.0 / 6) + s * (number<V>(0.15) + s * (number<V>(15.0 / 112) +
                                                             s * (number<V>(35.0 / 288) +
                                                                  s * number<V>(315.0 / 2816)))),
            (inverseW - h) * safe);

        // Strains times d, and moments.
        const V3<V> gap = (V(2) * h) * v - segment.rest;
        const V3<V> moment = {segment.bend * gap[0], segment.bend * gap[1], segment.twist * gap[2]};
        const V mv = dot(moment, v);
        const V3<V> n = V(2) * (h * moment + (V(2) * h1 * mv) * v);

        // The load on the chord. |a + b|^2 = 2 (1 + w).
        const V half = V(1) + r.w;
        const V root = inverseRoot(most(half, V(1e-6F)));
        const V scale = number<V>(std::numbers::sqrt2 / 2) * root;
        const Matrix<V, 3, 3> frame =
            rotation(Quaternion<V>{scale * (a.w + b.w), scale * (a.v + b.v)});
        const V3<V> f = transposed(frame) * force;
        const V3<V>& chord = segment.chord;
        const V3<V> g = cross(f, chord);
        const V3<V> tau = (root * root) * v;
        const V3<V> turn = cross(g, tau);

        // (w + [v]x) / 2 carries a rotation of b into v, its transpose one of a, negated; half of
        // 1 + [tau]x one of a into the middle frame, its transpose one of b.
        Derivatives<V, 3> d;
        const V3<V> p = g - turn;
        const V3<V> q = g + turn;
        const V3<V> vn = cross(v, n);
        d.gb = V(0.5F) * (r.w * n - vn + q);
        d.ga = V(0.5F) * (p - r.w * n - vn);
        if constexpr (order == Order::Gradient) return d;

        const V h2 = select(
            small,
            number<V>(0.15) + s * (number<V>(15.0 / 56) +
                                   s * (number<V>(35.0 / 96) +
                                        s * (number<V>(315.0 / 704) + s * number<V>(0.52246094)))),
            (V(0.5F) * inverseW * inverseW * inverseW - V(3) * h1) * safe);
        // 4 J K J, with J = h + 2 h1 v v', and what the moment adds.
        const V3<V> kv = {segment.bend * v[0], segment.bend * v[1], segment.twist * v[2]};
        const V3<V> u = (V(8) * h * h1) * kv + (V(4) * h1) * moment +
                        (V(8) * h1 * h1 * dot(v, kv) + V(4) * h2 * mv) * v;
        Matrix<V, 3, 3> hv = symmetricOuter(u, v);
        const V hh = V(4) * h * h;
        const V around = V(4) * h1 * mv;
        hv(0, 0) += hh * segment.bend + around;
        hv(1, 1) += hh * segment.bend + around;
        hv(2, 2) += hh * segment.twist + around;
        const auto bent = aboutBoth(V(0.5F) * r.w, V(0.5F) * v, hv);

        Matrix<V, 3, 3> hm = V(-0.5F) * symmetricOuter(f, chord);
        const V along = dot(f, chord);
        for (int i = 0; i < 3; ++i)
            hm(i, i) += along;
        const auto carried = aboutBoth(V(0.5F), V(0.5F) * tau, hm);

        const V nv = V(0.25F) * dot(n, v);
        const V gt = V(0.25F) * dot(g, tau);
        d.hbb = bent.minus + carried.minus + V(0.125F) * symmetricOuter(q, tau);
        d.haa = bent.plus + carried.plus - V(0.125F) * symmetricOuter(p, tau);
        d.hab = carried.across - bent.across + V(0.25F) * symmetricOuter(v, n) -
                V(0.125F) * (outer(tau, q) - outer(p, tau));
        const V3<V> wn = (V(0.25F) * r.w) * n;
        d.hab(2, 1) += wn[0];
        d.hab(1, 2) -= wn[0];
        d.hab(0, 2) += wn[1];
        d.hab(2, 0) -= wn[1];
        d.hab(1, 0) += wn[2];
        d.hab(0, 1) -= wn[2];
        for (int i = 0; i < 3; ++i) {
            d.hbb(i, i) -= nv + gt;
            d.haa(i, i) -= nv - gt;
            d.hab(i, i) -= nv;
        }
        if (withChords) {
            const Matrix<V, 3, 3> moves = V(-0.5F) * (frame * crossMatrix(chord));
            const Matrix<V, 3, 3> twisted = moves * crossMatrix(tau);
            d.a = moves - twisted;
            d.b = moves + twisted;
        }
        return d;
    }

private:
    // p q' + q p'.
    HWY_INLINE static Matrix<V, 3, 3> symmetricOuter(const V3<V>& p, const V3<V>& q) {
        Matrix<V, 3, 3> sum;
        for (int r = 0; r < 3; ++r)
            for (int c = r; c < 3; ++c)
                sum(r, c) = sum(c, r) = p[r] * q[c] + q[r] * p[c];
        return sum;
    }

    // With a matrix of s + [x]x and one of s - [x]x, and H = H' between them.
    struct Congruence {
        Matrix<V, 3, 3> minus;   // (s - [x]x) H (s + [x]x)
        Matrix<V, 3, 3> plus;    // (s + [x]x) H (s - [x]x)
        Matrix<V, 3, 3> across;  // (s + [x]x) H (s + [x]x)
    };

    HWY_INLINE static Congruence aboutBoth(V s, const V3<V>& x, const Matrix<V, 3, 3>& h) {
        Matrix<V, 3, 3> xh;  // [x]x H; its transpose is -H [x]x
        for (int c = 0; c < 3; ++c) {
            const V3<V> column = cross(x, V3<V>{h(0, c), h(1, c), h(2, c)});
            for (int r = 0; r < 3; ++r)
                xh(r, c) = column[r];
        }
        const V ss = s * s;
        Congruence all;
        for (int r = 0; r < 3; ++r) {
            const V3<V> xhx = cross(V3<V>{xh(r, 0), xh(r, 1), xh(r, 2)}, x);
            for (int c = r; c < 3; ++c) {
                const V even = ss * h(r, c) - xhx[c];
                const V odd = s * (xh(r, c) + xh(c, r));
                all.minus(r, c) = all.minus(c, r) = even - odd;
                all.plus(r, c) = all.plus(c, r) = even + odd;
                const V straight = ss * h(r, c) + xhx[c];
                const V skew = s * (xh(r, c) - xh(c, r));
                all.across(r, c) = straight + skew;
                all.across(c, r) = straight - skew;
            }
        }
        return all;
    }
};

}  // namespace kushi::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#endif
