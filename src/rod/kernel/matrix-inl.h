// SPDX-License-Identifier: Apache-2.0
//
// Small vectors and matrices of lanes.
#if defined(KUSHI_ROD_MATRIX_INL_H) == defined(HWY_TARGET_TOGGLE)
#ifdef KUSHI_ROD_MATRIX_INL_H
#undef KUSHI_ROD_MATRIX_INL_H
#else
#define KUSHI_ROD_MATRIX_INL_H
#endif

#include "core/lanes-inl.h"

HWY_BEFORE_NAMESPACE();
namespace kushi::HWY_NAMESPACE {

template <class V, int R, int C>
struct Matrix {
    V a[R][C];

    HWY_INLINE V& operator()(int r, int c) { return a[r][c]; }
    HWY_INLINE const V& operator()(int r, int c) const { return a[r][c]; }
};

template <class V, int R>
struct Column {
    V a[R];

    HWY_INLINE V& operator[](int r) { return a[r]; }
    HWY_INLINE const V& operator[](int r) const { return a[r]; }
};

template <class V>
using V3 = Column<V, 3>;

template <class V, int R>
HWY_INLINE Column<V, R> operator+(const Column<V, R>& p, const Column<V, R>& q) {
    Column<V, R> sum;
    for (int r = 0; r < R; ++r)
        sum[r] = p[r] + q[r];
    return sum;
}
template <class V, int R>
HWY_INLINE Column<V, R> operator-(const Column<V, R>& p, const Column<V, R>& q) {
    Column<V, R> difference;
    for (int r = 0; r < R; ++r)
        difference[r] = p[r] - q[r];
    return difference;
}
template <class V, int R>
HWY_INLINE Column<V, R> operator*(V s, const Column<V, R>& p) {
    Column<V, R> scaled;
    for (int r = 0; r < R; ++r)
        scaled[r] = s * p[r];
    return scaled;
}
template <class V, int R>
HWY_INLINE V dot(const Column<V, R>& p, const Column<V, R>& q) {
    V sum = p[0] * q[0];
    for (int r = 1; r < R; ++r)
        sum = sum + p[r] * q[r];
    return sum;
}
template <class V>
HWY_INLINE V3<V> cross(const V3<V>& p, const V3<V>& q) {
    return {p[1] * q[2] - p[2] * q[1], p[2] * q[0] - p[0] * q[2], p[0] * q[1] - p[1] * q[0]};
}
template <class V, int R>
HWY_INLINE Column<V, R> unit(const Column<V, R>& p) {
    return inverseRoot(dot(p, p)) * p;
}
template <class V, int R>
HWY_INLINE Column<V, R> select(MaskOf<V> which, const Column<V, R>& yes, const Column<V, R>& no) {
    Column<V, R> chosen;
    for (int r = 0; r < R; ++r)
        chosen[r] = select(which, yes[r], no[r]);
    return chosen;
}

template <class V, int R, int C>
HWY_INLINE Matrix<V, R, C> operator+(const Matrix<V, R, C>& p, const Matrix<V, R, C>& q) {
    Matrix<V, R, C> sum;
    for (int r = 0; r < R; ++r)
        for (int c = 0; c < C; ++c)
            sum(r, c) = p(r, c) + q(r, c);
    return sum;
}
template <class V, int R, int C>
HWY_INLINE Matrix<V, R, C> operator-(const Matrix<V, R, C>& p, const Matrix<V, R, C>& q) {
    Matrix<V, R, C> difference;
    for (int r = 0; r < R; ++r)
        for (int c = 0; c < C; ++c)
            difference(r, c) = p(r, c) - q(r, c);
    return difference;
}
template <class V, int R, int C>
HWY_INLINE Matrix<V, R, C> operator*(V s, const Matrix<V, R, C>& p) {
    Matrix<V, R, C> scaled;
    for (int r = 0; r < R; ++r)
        for (int c = 0; c < C; ++c)
            scaled(r, c) = s * p(r, c);
    return scaled;
}
template <class V, int R, int K, int C>
HWY_INLINE Matrix<V, R, C> operator*(const Matrix<V, R, K>& p, const Matrix<V, K, C>& q) {
    Matrix<V, R, C> product;
    for (int r = 0; r < R; ++r) {
        for (int c = 0; c < C; ++c) {
            V sum = p(r, 0) * q(0, c);
            for (int k = 1; k < K; ++k)
                sum = sum + p(r, k) * q(k, c);
            product(r, c) = sum;
        }
    }
    return product;
}
template <class V, int R, int C>
HWY_INLINE Column<V, R> operator*(const Matrix<V, R, C>& p, const Column<V, C>& q) {
    Column<V, R> product;
    for (int r = 0; r < R; ++r) {
        V sum = p(r, 0) * q[0];
        for (int c = 1; c < C; ++c)
            sum = sum + p(r, c) * q[c];
        product[r] = sum;
    }
    return product;
}
template <class V, int R, int C>
HWY_INLINE Matrix<V, C, R> transposed(const Matrix<V, R, C>& p) {
    Matrix<V, C, R> result;
    for (int r = 0; r < R; ++r)
        for (int c = 0; c < C; ++c)
            result(c, r) = p(r, c);
    return result;
}
template <class V, int R, int C>
HWY_INLINE Matrix<V, R, C> outer(const Column<V, R>& p, const Column<V, C>& q) {
    Matrix<V, R, C> product;
    for (int r = 0; r < R; ++r)
        for (int c = 0; c < C; ++c)
            product(r, c) = p[r] * q[c];
    return product;
}
template <int R, class V>
HWY_INLINE Matrix<V, R, R> diagonal(V x) {
    Matrix<V, R, R> result;
    for (int r = 0; r < R; ++r)
        for (int c = 0; c < R; ++c)
            result(r, c) = r == c ? x : V(0);
    return result;
}
// The matrix of p x.
template <class V>
HWY_INLINE Matrix<V, 3, 3> crossMatrix(const V3<V>& p) {
    return {{{V(0), -p[2], p[1]}, {p[2], V(0), -p[0]}, {-p[1], p[0], V(0)}}};
}

// M = L D L' of a symmetric matrix, kept as unit L and 1 / D.
template <class V, int R>
struct Factors {
    Matrix<V, R, R> lower;
    V inverse[R];

    HWY_INLINE Column<V, R> solve(Column<V, R> x) const {
        for (int r = 1; r < R; ++r)
            for (int k = 0; k < r; ++k)
                x[r] = x[r] - lower(r, k) * x[k];
        for (int r = 0; r < R; ++r)
            x[r] = x[r] * inverse[r];
        for (int r = R - 2; r >= 0; --r)
            for (int k = r + 1; k < R; ++k)
                x[r] = x[r] - lower(k, r) * x[k];
        return x;
    }
    template <int C>
    HWY_INLINE Matrix<V, R, C> solve(const Matrix<V, R, C>& x) const {
        Matrix<V, R, C> result;
        for (int c = 0; c < C; ++c) {
            Column<V, R> column;
            for (int r = 0; r < R; ++r)
                column[r] = x(r, c);
            column = solve(column);
            for (int r = 0; r < R; ++r)
                result(r, c) = column[r];
        }
        return result;
    }
};

// `positive` keeps the lanes whose pivots are greater than `least`; the others go on with a finite
// stand-in. A pivot that is not a number fails the test.
template <class V, int R>
HWY_INLINE Factors<V, R> factorize(const Matrix<V, R, R>& m, V least, MaskOf<V>& positive) {
    Factors<V, R> f;
    V pivot[R];
    for (int c = 0; c < R; ++c) {
        V d = m(c, c);
        for (int k = 0; k < c; ++k)
            d = d - f.lower(c, k) * f.lower(c, k) * pivot[k];
        const MaskOf<V> good = d > least;
        positive = positive & good;
        pivot[c] = select(good, d, V(1));
        f.inverse[c] = reciprocal(pivot[c]);
        for (int r = c + 1; r < R; ++r) {
            V x = m(r, c);
            for (int k = 0; k < c; ++k)
                x = x - f.lower(r, k) * f.lower(c, k) * pivot[k];
            f.lower(r, c) = x * f.inverse[c];
        }
    }
    return f;
}

}  // namespace kushi::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#endif
