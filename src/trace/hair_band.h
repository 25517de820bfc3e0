// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "shading/fibre_model.h"
#include "trace/brightness.h"
#include "trace/fast_math.h"

#include <array>
#include <cstddef>

namespace kushi {

/// Light from one direction.
struct Response {
    Rgb value;      ///< f |cos|
    float pdf = 0;  ///< with which sampling gives that direction, 1/sr
};

/// Evenly spaced places across a hair.
struct Places {
    static constexpr std::size_t count = 8;
    float first = 0, step = 0;  ///< h of the first, and from each to the next

    float h(std::size_t k) const { return first + static_cast<float>(k) * step; }

    /// Over the whole width, the first as far into its eighth as `random` in [0, 1) says.
    static Places all(float random) {
        constexpr float step = 2.0F / count;
        return {random * step - 1, step};
    }
    /// All the same.
    static Places one(float h) { return {h, 0}; }
};

/// A hair seen from one direction at several places across it, for the mean of what they send to
/// the eye: FibreView, in lanes. The glints of single places, which chance rarely finds, are
/// spread over the hair's width by it.
class HairBand {
public:
    /// tilt    of this hair's scales beyond the model's [rad]
    /// wanted  what a unit of each colour is worth; lobes are sampled accordingly
    HairBand(const FibreModel<float>& model, Places places, float sinOut, float cosOut, float tilt,
             Rgb absorption, Rgb wanted)
        : model_(model), out_(model.outgoing(sinOut, cosOut, tilt)) {
        const float sinInside = sinOut / model.eta;
        const float bend = cosOut / std::sqrt(model.eta * model.eta - sinOut * sinOut);
        const float slant = -2 / std::sqrt(1 - sinInside * sinInside);
        for (std::size_t k = 0; k < Places::count; ++k) {
            const float h = places.h(k);
            const float inside = h * bend;
            gamma_[k] = fastAsin(h);
            gammaInside_[k] = fastAsin(inside);
            const float path = slant * std::sqrt(std::max(0.0F, 1 - inside * inside));
            const float f = fresnel(cosOut * std::sqrt(std::max(0.0F, 1 - h * h)), model.eta);
            attenuate(k, f, fastExp(absorption.r * path), fastExp(absorption.g * path),
                      fastExp(absorption.b * path), wanted);
        }
    }

    /// The mean over the places. If each is as likely to be sampled, by its shares(), pdf is the
    /// density of that.
    Response response(FibreIncidence<float> in) const {
        Lanes r{};
        Lanes g{};
        Lanes b{};
        Lanes pdf{};
        for (std::size_t p = 0; p < 4; ++p) {
            const float along = model_.strayAlong(model_.along[p], in.sinTheta, in.cosTheta,
                                                  out_.sine[p], out_.cosine[p]);
            if (along < 1e-7F) continue;
            const Lanes spread = around(p, along, in.phi);
            const Part& part = parts_[p];
            for (std::size_t k = 0; k < Places::count; ++k) {
                r[k] += spread[k] * part.r[k];
                g[k] += spread[k] * part.g[k];
                b[k] += spread[k] * part.b[k];
                pdf[k] += spread[k] * part.share[k];
            }
        }
        return {{mean(r), mean(g), mean(b)}, mean(pdf)};
    }

    /// A_p at place k, and the chances with which its ways are to be sampled.
    std::array<Rgb, 4> parts(std::size_t k) const {
        std::array<Rgb, 4> at;
        for (std::size_t p = 0; p < 4; ++p)
            at[p] = {parts_[p].r[k], parts_[p].g[k], parts_[p].b[k]};
        return at;
    }
    std::array<float, 4> shares(std::size_t k) const {
        return {parts_[0].share[k], parts_[1].share[k], parts_[2].share[k], parts_[3].share[k]};
    }

private:
    using Lanes = std::array<float, Places::count>;
    struct Part {
        Lanes r, g, b, share;
    };

    static float mean(const Lanes& lanes) {
        float sum = 0;
        for (const float lane : lanes)
            sum += lane;
        return sum / Places::count;
    }

    /// f: Fresnel's share; r, g, b: what is left of light from wall to wall.
    void attenuate(std::size_t k, float f, float r, float g, float b, Rgb wanted) {
        const float entering = (1 - f) * (1 - f);
        const auto rest = [&](float t) {
            return entering * f * f * t * t * t / std::max(1 - t * f, 1e-20F);
        };
        const std::array<Rgb, 4> parts = {Rgb{f, f, f},
                                          entering * Rgb{r, g, b},
                                          entering * f * Rgb{r * r, g * g, b * b},
                                          {rest(r), rest(g), rest(b)}};
        std::array<float, 4> shares{};
        float sum = 1e-30F;
        for (std::size_t p = 0; p < 4; ++p) {
            shares[p] = luminance(wanted * parts[p]);
            sum += shares[p];
        }
        for (std::size_t p = 0; p < 4; ++p) {
            parts_[p].r[k] = parts[p].r;
            parts_[p].g[k] = parts[p].g;
            parts_[p].b[k] = parts[p].b;
            parts_[p].share[k] = shares[p] / sum;
        }
    }

    /// N_p of each place, times `along`.
    Lanes around(std::size_t p, float along, float phi) const {
        constexpr float pi = std::numbers::pi_v<float>;
        Lanes spread;
        if (p == 3) {
            spread.fill(along / (2 * pi));
            return spread;
        }
        const auto times = static_cast<float>(p);
        const float from = phi - times * pi;
        const float scale = along * model_.aroundScale;
        for (std::size_t k = 0; k < Places::count; ++k) {
            float x = from - 2 * (times * gammaInside_[k] - gamma_[k]);
            x -= 2 * pi * nearest(x * (1 / (2 * pi)));
            const float e = fastExp(-std::abs(x) * model_.inverseWidth);
            spread[k] = scale * e / ((1 + e) * (1 + e));
        }
        return spread;
    }

    const FibreModel<float>& model_;
    FibreModel<float>::Outgoing out_;
    std::array<Part, 4> parts_;
    Lanes gamma_, gammaInside_;
};

}  // namespace kushi
