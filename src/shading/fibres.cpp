// SPDX-License-Identifier: Apache-2.0
// Dual scattering: Zinke, Yuksel, Weber & Keyser, "Dual Scattering Approximation for Fast Multiple
// Scattering in Hair" (2008).
#include "core/parallel.h"
#include "core/random.h"
#include "shading/far_field.h"
#include "shading/fibre_model.h"
#include "shading/tangents.h"

#include <kushi/shadows.h>

#include <algorithm>
#include <cmath>
#include <numbers>

namespace kushi {

namespace {

constexpr float pi = std::numbers::pi_v<float>;
constexpr std::uint64_t tiltSalt = 0x74696c74;

float perChannel(Rgb color, std::size_t channel) {
    return channel == 0 ? color.r : channel == 1 ? color.g : color.b;
}

/// The pigment of one node, channel by channel.
struct Pigment {
    std::array<float, 3> absorption{};
    std::array<FarField::Albedo, 3> albedo;

    Pigment(Rgb sigma, const FarField& far) {
        for (std::size_t c = 0; c < 3; ++c) {
            absorption[c] = perChannel(sigma, c);
            albedo[c] = far.albedo(absorption[c]);
        }
    }
};

/// A direction from a fibre: along it, and around it in a frame of its own.
struct Around {
    float sinTheta = 0, cosTheta = 1;
    Vec3f across;  // not normalized

    Around(Vec3f tangent, Vec3f direction)
        : sinTheta(std::clamp(dot(tangent, direction), -1.0F, 1.0F)),
          cosTheta(std::sqrt(1 - sinTheta * sinTheta)),
          across(direction - sinTheta * tangent) {}
};

float angleBetween(const Around& a, const Around& b) {
    const float sizes = a.cosTheta * b.cosTheta;
    if (sizes < 1e-6F) return pi / 2;
    return std::acos(std::clamp(dot(a.across, b.across) / sizes, -1.0F, 1.0F));
}

class FibreShading {
public:
    FibreShading(const FibreLook& look, const Lights& lights)
        : look_(look), lights_(lights), model_(look.fibre), far_(look.fibre) {
        for (std::size_t p = 0; p < 3; ++p)
            variance_[p] = 1 / model_.along[p].inverseVariance;
        // What comes back from near hair went through some and came back from one.
        backVariance_ = 2 * (variance_[0] + variance_[1]);
    }

    Pigment pigment(Rgb color) const {
        return {absorptionOfColor(color, look_.fibre.azimuthal), far_};
    }

    /// tilt  by which this strand's scales differ [rad]
    Rgb node(Vec3f tangent, float tilt, Vec3f toEye, const Pigment& pigment, const Shadows::Sky& sky,
             std::span<const Passage> passages) const {
        const Around out(tangent, toEye);
        std::array<float, 3> sum = ambient(pigment, sky);
        for (std::size_t i = 0; i < passages.size(); ++i) {
            const Passage& passage = passages[i];
            if (passage.free <= 0) continue;
            const Around in(tangent, lights_.distant[i].direction);
            const std::array<float, 3> share = scattered(out, in, tilt, pigment, passage.crossings);
            for (std::size_t c = 0; c < 3; ++c) {
                // A white matt surface shows 1/pi of the light that meets it.
                sum[c] += pi * passage.free * perChannel(lights_.distant[i].color, c) * share[c];
            }
        }
        return {sum[0], sum[1], sum[2]};
    }

private:
    /// From the eye's side hair sends light back, from beyond it lets it through.
    std::array<float, 3> ambient(const Pigment& pigment, const Shadows::Sky& sky) const {
        const auto reaching = [](Passage passage, float forward) {
            return passage.free * std::exp(-passage.crossings * (1 - forward));
        };
        std::array<float, 3> sum{};
        for (std::size_t c = 0; c < 3; ++c) {
            const auto& [forward, backward, local] = pigment.albedo[c];
            sum[c] = perChannel(lights_.ambient, c) *
                     (reaching(sky.here, forward) * (backward + look_.density * local) +
                      reaching(sky.beyond, forward) * forward);
        }
        return sum;
    }

    /// M of a lobe with a variance of its own.
    float along(std::size_t lobe, float variance, const Around& out, const Around& in,
                float tilt) const {
        const auto& tilted = model_.along[lobe];
        // Reflection turns by twice the tilt, two passages by minus one, four by minus two.
        static constexpr std::array<float, 3> times = {2, -1, -4};
        const float turn = times[lobe] * tilt;
        const float sine = tilted.sinTilt + tilted.cosTilt * turn;
        const float cosine = tilted.cosTilt - tilted.sinTilt * turn;
        const float sinOut = out.sinTheta * cosine + out.cosTheta * sine;
        const float cosOut = std::abs(out.cosTheta * cosine - out.sinTheta * sine);
        return stray(variance, in.sinTheta, in.cosTheta, sinOut, cosOut);
    }

    static float stray(float variance, float sinIn, float cosIn, float sinOut, float cosOut) {
        const float inverse = 1 / variance;
        const float both = cosIn * cosOut;
        const float scale = inverse / (1 - std::exp(-2 * inverse));
        return scale * besselI0Scaled(both * inverse) *
               std::exp((both - sinIn * sinOut - 1) * inverse);
    }

    /// Response per channel to light from one direction, after `crossings` fibres on average.
    std::array<float, 3> scattered(const Around& out, const Around& in, float tilt,
                                   const Pigment& pigment, float crossings) const {
        const float phi = angleBetween(out, in);
        const float thetaOut = std::asin(out.sinTheta);
        const float thetaIn = std::asin(in.sinTheta);
        const FarField::Around around = far_.around(std::sin(0.5F * (thetaIn - thetaOut)), phi);
        const float none = std::exp(-crossings);
        // Fibres crossed by what has crossed any.
        const float some = crossings / std::max(1 - none, 1e-4F);
        const float widening = std::max(some, 1.0F) * variance_[1];

        std::array<float, 3> direct{};
        std::array<float, 3> passed{};
        for (std::size_t p = 0; p < 3; ++p) {
            direct[p] = along(p, variance_[p], out, in, tilt);
            passed[p] = along(p, variance_[p] + widening, out, in, tilt);
        }
        const float backAround = (1 + std::cos(phi)) / (2 * pi);
        const float back = backAround * stray(backVariance_, in.sinTheta, in.cosTheta,
                                              out.sinTheta, out.cosTheta);

        std::array<float, 3> sum{};
        for (std::size_t c = 0; c < 3; ++c) {
            const float tt = std::exp(-pigment.absorption[c] * around.pathTt);
            const float trt = std::exp(-pigment.absorption[c] * around.pathTrt);
            const auto& albedo = pigment.albedo[c];
            const float near = look_.density * albedo.local * back;
            const float through =
                look_.density * (std::exp(-crossings * (1 - albedo.forward)) - none);
            sum[c] = none * (direct[0] * around.r + direct[1] * around.tt * tt +
                             direct[2] * around.trt * trt + near) +
                     through * (passed[0] * around.rHalf + passed[1] * around.ttHalf * tt +
                                passed[2] * around.trtHalf * trt + near);
        }
        return sum;
    }

    const FibreLook& look_;
    const Lights& lights_;
    FibreModel<float> model_;
    FarField far_;
    std::array<float, 3> variance_{};
    float backVariance_ = 0;
};

/// In [-1, 1], of a strand.
float strandVariation(const Strands& strands, std::size_t strand) {
    const std::uint64_t key = strands.keys.empty() ? strand : strands.keys[strand];
    return static_cast<float>(uniformSigned(mixKey(key, tiltSalt)));
}

}  // namespace

void shade(const Strands& strands, const Lights& lights, const Shadows& shadows,
           const FibreLook& look, Vec3f eye, std::span<Rgb> colors, int threads) {
    const FibreShading shading(look, lights);
    const Pigment usual = shading.pigment(look.color);
    parallelFor(strands.size(), 256, threads, [&](std::size_t begin, std::size_t end) {
        std::vector<Passage> passages(lights.distant.size());
        for (std::size_t i = begin; i < end; ++i) {
            const std::size_t first = strands.offsets[i];
            const float tilt = look.tiltVariation * strandVariation(strands, i);
            Pigment pigment = usual;
            Rgb last = look.color;
            forEachTangent(strands.strand(i), [&](std::size_t j, Vec3f tangent) {
                const std::size_t node = first + j;
                if (!strands.colors.empty() && strands.colors[node] != last) {
                    last = strands.colors[node];
                    pigment = shading.pigment(last);
                }
                const Vec3f place = strands.nodes[node];
                const Vec3f toEye = directionBetween(place, eye);
                shadows.at(place, passages);
                colors[node] = shading.node(tangent, tilt, toEye, pigment,
                                            shadows.skyAt(place, toEye), passages);
            });
        }
    });
}

}  // namespace kushi
