// SPDX-License-Identifier: Apache-2.0
// Dual scattering: Zinke, Yuksel, Weber & Keyser, "Dual Scattering Approximation for Fast Multiple
// Scattering in Hair" (2008).
#include "core/float4.h"
#include "core/parallel.h"
#include "shading/far_field.h"
#include "shading/fibre_model.h"
#include "shading/strand_tilt.h"
#include "shading/tangents.h"

#include <kushi/shadows.h>

#include <algorithm>
#include <cmath>
#include <numbers>

namespace kushi {

namespace {

constexpr float pi = std::numbers::pi_v<float>;
// Behind so many fibres nobody sees a node but one in thousands.
constexpr float hidden = 8;
constexpr float inTheDark = 0.1F;

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

/// Four directions from a fibre, against the one to the eye.
struct Directions {
    Float4 sinIn, cosIn;  ///< of the angle to the normal plane
    Float4 phi, cosPhi;   ///< around the fibre, from the eye
};

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
    Rgb node(Vec3f tangent, float tilt, Vec3f toEye, const Pigment& pigment,
             const Shadows::Sky& sky, std::span<const Passage> passages) const {
        const Float4 forward = channels(pigment, &FarField::Albedo::forward);
        const Float4 pastBehind = exponential(-sky.beyond.crossings * (1 - forward));
        // What hair close by sends back, where there is any behind.
        const Float4 near = channels(pigment, &FarField::Albedo::local) * (1 - pastBehind);
        // From the eye's side hair sends light back, from beyond it lets it through.
        const Float4 ambient = sky.here.free * exponential(-sky.here.crossings * (1 - forward)) *
                                   (channels(pigment, &FarField::Albedo::backward) + near) +
                               sky.beyond.free * pastBehind * forward;
        Rgb sum = lights_.ambient * Rgb{ambient[0], ambient[1], ambient[2]};
        for (std::size_t i = 0; i < passages.size(); i += 4)
            sum += fromLights(i, tangent, tilt, toEye, pigment, near, passages);
        return sum;
    }

private:
    static Float4 channels(const Pigment& pigment, float FarField::Albedo::*part) {
        return Float4{pigment.albedo[0].*part, pigment.albedo[1].*part, pigment.albedo[2].*part, 0};
    }

    /// What four lights from the first on add.
    Rgb fromLights(std::size_t first, Vec3f tangent, float tilt, Vec3f toEye,
                   const Pigment& pigment, Float4 near, std::span<const Passage> passages) const {
        const float sinOut = std::clamp(dot(tangent, toEye), -1.0F, 1.0F);
        const float cosOut = std::sqrt(1 - sinOut * sinOut);
        Float4 sinIn{};
        Float4 facing{};
        Float4 crossings{};
        std::array<Float4, 3> light{};
        for (std::size_t i = first; i < std::min(first + 4, passages.size()); ++i) {
            const Vec3f direction = lights_.distant[i].direction;
            const Rgb color = lights_.distant[i].color;
            const std::size_t lane = i - first;
            sinIn[lane] = std::clamp(dot(tangent, direction), -1.0F, 1.0F);
            facing[lane] = dot(toEye, direction);
            crossings[lane] = passages[i].crossings;
            // A white matt surface shows 1/pi of the light that meets it.
            const Rgb reaching = pi * passages[i].free * color;
            light[0][lane] = reaching.r;
            light[1][lane] = reaching.g;
            light[2][lane] = reaching.b;
        }
        const Float4 cosIn = squareRoot(1 - sinIn * sinIn);
        const Float4 around = (facing - sinIn * sinOut) / larger(cosIn * cosOut, float4(1e-6F));
        const Float4 cosPhi = smaller(larger(around, float4(-1)), float4(1));
        const std::array<Float4, 3> share =
            scattered({sinIn, cosIn, arcCosine(cosPhi), cosPhi}, sinOut, cosOut, tilt, pigment,
                      near, crossings);
        const auto sum = [&](std::size_t c) {
            const Float4 product = light[c] * share[c];
            return (product[0] + product[1]) + (product[2] + product[3]);
        };
        return {sum(0), sum(1), sum(2)};
    }

    /// M, with exp(-x) I0(x) to 1.4 %.
    static Float4 stray(Float4 variance, const Directions& in, float sinOut, float cosOut) {
        const Float4 inverse = 1 / variance;
        const Float4 both = in.cosIn * cosOut;
        const Float4 x = both * inverse;
        const Float4 bessel = 1 + (2 * pi) * x * (0.390702F + x * (1.027749F + x)) /
                                      (1.529653F + x * (1.543265F + x));
        return inverse * exponential((both - in.sinIn * sinOut - 1) * inverse) /
               ((1 - exponential(-2 * inverse)) * squareRoot(bessel));
    }

    /// Response per channel to four lights, after so many crossings on average.
    std::array<Float4, 3> scattered(const Directions& in, float sinOut, float cosOut, float tilt,
                                    const Pigment& pigment, Float4 near, Float4 crossings) const {
        const Float4 cosDifference = in.cosIn * cosOut + in.sinIn * sinOut;
        const Float4 sinHalf = squareRoot(larger(0.5F - 0.5F * cosDifference, float4(0)));
        const FarField::Around around = far_.around(sinHalf, in.phi);
        const Float4 none = exponential(-crossings);
        // Fibres crossed by what has crossed any.
        const Float4 some = larger(crossings / larger(1 - none, float4(1e-4F)), float4(1));

        std::array<Float4, 3> direct{};
        std::array<Float4, 3> passed{};
        for (std::size_t p = 0; p < 3; ++p) {
            // Reflection turns by twice the tilt, two passages by minus one, four by minus two.
            static constexpr std::array<float, 3> times = {2, -1, -4};
            const float turn = times[p] * tilt;
            const auto& lobe = model_.along[p];
            const float sine = lobe.sinTilt + lobe.cosTilt * turn;
            const float cosine = lobe.cosTilt - lobe.sinTilt * turn;
            const float sinTurned = sinOut * cosine + cosOut * sine;
            const float cosTurned = std::abs(cosOut * cosine - sinOut * sine);
            direct[p] = stray(float4(variance_[p]), in, sinTurned, cosTurned);
            passed[p] = stray(variance_[p] + some * variance_[1], in, sinTurned, cosTurned);
        }
        direct[0] *= around.r;
        passed[0] *= around.rHalf;
        const Float4 back =
            (1 + in.cosPhi) * (1 / (2 * pi)) * stray(float4(backVariance_), in, sinOut, cosOut);

        std::array<Float4, 3> sum{};
        for (std::size_t c = 0; c < 3; ++c) {
            const Float4 tt = exponential(-pigment.absorption[c] * around.pathTt);
            const Float4 trt = exponential(-pigment.absorption[c] * around.pathTrt);
            const auto& albedo = pigment.albedo[c];
            const Float4 sentBack = look_.density * near[c] * back;
            const Float4 through =
                look_.density * (exponential(-crossings * (1 - albedo.forward)) - none);
            sum[c] = none * (direct[0] + direct[1] * around.tt * tt + direct[2] * around.trt * trt +
                             sentBack) +
                     through * (passed[0] + passed[1] * around.ttHalf * tt +
                                passed[2] * around.trtHalf * trt + sentBack);
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

}  // namespace

void shade(const Strands& strands, const Lights& lights, const Shadows& shadows,
           const FibreLook& look, Vec3f eye, std::span<Rgb> colors, int threads) {
    const FibreShading shading(look, lights);
    const Pigment usual = shading.pigment(look.color);
    const std::vector<float> before = shadows.crossingsBefore(strands.nodes, eye, threads);
    parallelFor(strands.size(), 256, threads, [&](std::size_t begin, std::size_t end) {
        std::vector<Passage> passages(lights.distant.size());
        for (std::size_t i = begin; i < end; ++i) {
            const std::size_t first = strands.offsets[i];
            const std::size_t size = strands.offsets[i + 1] - first;
            const float tilt = look.tiltVariation * strandTilt(strands, i);
            Pigment pigment = usual;
            Rgb last = look.color;
            forEachTangent(strands.strand(i), [&](std::size_t j, Vec3f tangent) {
                const std::size_t node = first + j;
                const Rgb color = strands.colors.empty() ? look.color : strands.colors[node];
                // What its neighbours show counts too, as segments mix the colours of their ends.
                const float nearest = std::min({before[node], before[j > 0 ? node - 1 : node],
                                                before[j + 1 < size ? node + 1 : node]});
                if (nearest > hidden) {
                    colors[node] = inTheDark * (lights.ambient * color);
                    return;
                }
                if (color != last) {
                    last = color;
                    pigment = shading.pigment(color);
                }
                const Vec3f place = strands.nodes[node];
                const Vec3f toEye = directionBetween(place, eye);
                const Shadows::Sky sky = shadows.at(place, toEye, passages);
                colors[node] = shading.node(tangent, tilt, toEye, pigment, sky, passages);
            });
        }
    });
}

}  // namespace kushi
