// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "shading/bessel.h"

#include <kushi/fibre.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <numbers>

namespace kushi {

/// Chiang's model in doubles, for truth, or in floats, for pictures. What depends on the fibre
/// alone is kept here; what depends on where it is seen from, in FibreView.
template <class T>
struct FibreModel {
    static constexpr T pi = std::numbers::pi_v<T>;

    /// M: how far light of one lobe strays along the fibre (d'Eon et al. 2011, eq. 7).
    struct Longitudinal {
        T inverseVariance = 0;
        T scale = 0;                 ///< 1 / (v (1 - exp(-2 / v)))
        T sinTilt = 0, cosTilt = 1;  ///< by which the outgoing direction is turned
    };

    /// The direction to the eye as each way meets it, turned by the tilt of the scales.
    struct Outgoing {
        std::array<T, 4> sine{}, cosine{};
    };

    T eta = 0;
    std::array<Longitudinal, 4> along;
    T inverseWidth = 0;  ///< of the logistic that strays around the fibre
    T edge = 0;          ///< its cumulative distribution at -pi
    T aroundScale = 0;   ///< 1 / (width (1 - 2 edge))

    explicit FibreModel(const Fibre& fibre) : eta(static_cast<T>(fibre.eta)) {
        const double bm = fibre.longitudinal;
        const double bn = fibre.azimuthal;
        const double root = 0.726 * bm + 0.812 * bm * bm + 3.7 * std::pow(bm, 20);
        const double v = root * root;
        // Reflection at a scale turns light by twice its tilt, passing through two by minus one.
        along = {longitudinal(v, 2 * fibre.tilt), longitudinal(v / 4, -fibre.tilt),
                 longitudinal(4 * v, -4 * fibre.tilt), longitudinal(4 * v, 0)};
        const double s = std::sqrt(std::numbers::pi / 8) *
                         (0.265 * bn + 1.194 * bn * bn + 5.372 * std::pow(bn, 22));
        const double tail = 1 / (1 + std::exp(std::numbers::pi / s));
        inverseWidth = static_cast<T>(1 / s);
        edge = static_cast<T>(tail);
        aroundScale = static_cast<T>(1 / (s * (1 - 2 * tail)));
    }

    /// M cos(theta_i) integrates to 1 over theta_i.
    T strayAlong(const Longitudinal& lobe, T sinIn, T cosIn, T sinOut, T cosOut) const {
        const T both = cosIn * cosOut;
        return lobe.scale * besselI0Scaled(both * lobe.inverseVariance) *
               std::exp((both - sinIn * sinOut - 1) * lobe.inverseVariance);
    }

    /// tilt  by which this fibre's scales are tilted more than the model's [rad]
    Outgoing outgoing(T sinOut, T cosOut, T tilt) const {
        const T s = std::sin(tilt);
        const T c = std::cos(tilt);
        const T s2 = 2 * s * c;
        const T c2 = c * c - s * s;
        // By as many times as the model's own tilt.
        const std::array<T, 4> sines = {s2, -s, -2 * s2 * c2, 0};
        const std::array<T, 4> cosines = {c2, c, c2 * c2 - s2 * s2, 1};
        Outgoing out;
        for (std::size_t p = 0; p < 4; ++p) {
            const T sine = along[p].sinTilt * cosines[p] + along[p].cosTilt * sines[p];
            const T cosine = along[p].cosTilt * cosines[p] - along[p].sinTilt * sines[p];
            out.sine[p] = sinOut * cosine + cosOut * sine;
            out.cosine[p] = std::abs(cosOut * cosine - sinOut * sine);
        }
        return out;
    }

    /// N: the logistic cut off at +-pi, `x` from its middle.
    T strayAround(T x) const {
        x -= 2 * pi * std::nearbyint(x * (1 / (2 * pi)));
        const T e = std::exp(-std::abs(x) * inverseWidth);
        return aroundScale * e / ((1 + e) * (1 + e));
    }

    /// Distributed as N, from u in [0, 1).
    T sampleAround(T u) const {
        const T share = edge + u * (1 - 2 * edge);
        const T x = -std::log(1 / share - 1) / inverseWidth;
        return std::clamp(x, -pi, pi);
    }

private:
    static Longitudinal longitudinal(double v, double tilt) {
        return {static_cast<T>(1 / v), static_cast<T>(1 / (v * (1 - std::exp(-2 / v)))),
                static_cast<T>(std::sin(tilt)), static_cast<T>(std::cos(tilt))};
    }
};

/// Share of light that glass of index `eta` reflects, the cosine being of the angle outside.
template <class T>
T fresnel(T cosine, T eta) {
    const T inside = std::sqrt(std::max(T(0), 1 - (1 - cosine * cosine) / (eta * eta)));
    const T parallel = (eta * cosine - inside) / (eta * cosine + inside);
    const T across = (cosine - eta * inside) / (cosine + eta * inside);
    return (parallel * parallel + across * across) / 2;
}

/// A direction from which light comes, phi from the direction in which the fibre is seen.
template <class T>
struct FibreIncidence {
    T sinTheta = 0, cosTheta = 1, phi = 0;
};

/// One place across a fibre, seen from one direction.
template <class T>
class FibreView {
public:
    /// h in [-1, 1]; the outgoing direction's theta by sine and cosine; `tilt` beyond the model's.
    FibreView(const FibreModel<T>& model, T h, T sinOut, T cosOut, T tilt = 0)
        : model_(model), out_(model.outgoing(sinOut, cosOut, tilt)) {
        const T sinInside = sinOut / model.eta;
        const T sinGammaInside = h * cosOut / std::sqrt(model.eta * model.eta - sinOut * sinOut);
        const T cosGammaInside = std::sqrt(std::max(T(0), 1 - sinGammaInside * sinGammaInside));
        path_ = 2 * cosGammaInside / std::sqrt(1 - sinInside * sinInside);
        reflected_ = fresnel(cosOut * std::sqrt(std::max(T(0), 1 - h * h)), model.eta);
        gamma_ = std::asin(h);
        gammaInside_ = std::asin(sinGammaInside);
    }

    /// A_p: share of the light that each way sends on (Chiang et al. 2016, eq. 6).
    std::array<T, 4> attenuations(T absorption) const {
        const T f = reflected_;
        const T through = std::exp(-absorption * path_);
        const T tt = (1 - f) * (1 - f) * through;
        const T trt = tt * through * f;
        // Not 0 / 0 at the fibre's very edge.
        const T left = std::max(1 - through * f, T(1e-20));
        return {f, tt, trt, trt * through * f / left};
    }

    /// M_p N_p: how each way spreads over the directions `in` [1/sr].
    std::array<T, 4> spread(FibreIncidence<T> in) const {
        std::array<T, 4> values{};
        for (std::size_t p = 0; p < 4; ++p) {
            values[p] = model_.strayAlong(model_.along[p], in.sinTheta, in.cosTheta, out_.sine[p],
                                          out_.cosine[p]);
        }
        for (std::size_t p = 0; p < 3; ++p)
            values[p] *= model_.strayAround(in.phi - turn(p));
        values[3] *= 1 / (2 * FibreModel<T>::pi);
        return values;
    }

    /// N_p alone, how a way p < 3 spreads around the fibre [1/rad].
    T around(std::size_t p, T phi) const { return model_.strayAround(phi - turn(p)); }

    /// A direction with the density spread()[p]; u, v, w in [0, 1) (d'Eon et al. 2013, for M).
    FibreIncidence<T> sample(std::size_t p, T u, T v, T w) const {
        constexpr T pi = FibreModel<T>::pi;
        const auto& lobe = model_.along[p];
        const T share = 1 - u;  // never 0, of which there is no logarithm
        const T cosine =
            std::max(T(-1), 1 + std::log(share + u * std::exp(-2 * lobe.inverseVariance)) /
                                    lobe.inverseVariance);
        const T sine = std::sqrt(std::max(T(0), 1 - cosine * cosine));
        FibreIncidence<T> in;
        in.sinTheta = std::clamp(
            sine * std::cos(2 * pi * v) * out_.cosine[p] - cosine * out_.sine[p], T(-1), T(1));
        in.cosTheta = std::sqrt(1 - in.sinTheta * in.sinTheta);
        in.phi = p < 3 ? turn(p) + model_.sampleAround(w) : 2 * pi * w;
        return in;
    }

private:
    /// Phi(p): how far around a smooth fibre turns light.
    T turn(std::size_t p) const {
        const T times = static_cast<T>(p);
        return 2 * times * gammaInside_ - 2 * gamma_ + times * FibreModel<T>::pi;
    }

    const FibreModel<T>& model_;
    typename FibreModel<T>::Outgoing out_;
    T path_ = 0;       // inside, from wall to wall, in radii
    T reflected_ = 0;  // Fresnel's share
    T gamma_ = 0, gammaInside_ = 0;
};

}  // namespace kushi
