// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "geometry/axes.h"
#include "trace/hair_band.h"
#include "trace/ray_scene.h"
#include "trace/sampler.h"

namespace kushi {

/// A direction that light was followed along, and what that makes of it.
struct Turn {
    Vec3f direction;
    Rgb weight;       ///< response / pdf, in the mean
    bool ok = false;  ///< else the light is lost
};

/// A place on a hair that a ray has met.
struct HairSpot {
    Vec3f axis;        ///< m, on the hair's axis
    Vec3f tangent;     ///< unit, interpolated between nodes
    Vec3f segment;     ///< unit, of the straight segment
    float radius = 0;  ///< m
    float h = 0;       ///< across, as fibreResponse() has it
    float tilt = 0;    ///< of its scales beyond the look's [rad]
    Rgb absorption;
};

/// How light is scattered there towards the eye.
class HairPoint {
public:
    /// toEye   unit
    /// places  across the hair, whose mean is shown
    /// wanted  what a unit of each colour is worth; lobes are sampled accordingly
    HairPoint(const FibreModel<float>& model, const HairSpot& spot, Vec3f toEye, Places places,
              Rgb wanted)
        : model_(model),
          spot_(spot),
          places_(places),
          outward_(outwardOf(spot.tangent, toEye)),
          around_(cross(spot.tangent, outward_)),
          sinOut_(sineOf(toEye)),
          cosOut_(cosineOf(sinOut_)),
          band_(model, places, sinOut_, cosOut_, spot.tilt, spot.absorption, wanted) {}

    Response response(Vec3f in) const {
        const float sine = sineOf(in);
        return band_.response(
            {sine, cosineOf(sine), std::atan2(dot(in, around_), dot(in, outward_))});
    }

    /// From the place that was met, or the one next to it.
    Turn sample(Pair a, float w) const {
        const auto met = static_cast<std::size_t>((spot_.h + 1) / 2 * Places::count);
        const std::size_t k = std::min(met, Places::count - 1);
        const std::array<float, 4> shares = band_.shares(k);
        std::size_t p = 0;
        float before = 0;
        while (p < 3 && a.u >= before + shares[p])
            before += shares[p++];
        if (!(shares[p] > 0)) return {};
        // What is left of u is uniform again.
        const float rest = std::clamp((a.u - before) / shares[p], 0.0F, 1 - 0x1p-24F);
        const FibreView<float> view(model_, places_.h(k), sinOut_, cosOut_, spot_.tilt);
        const FibreIncidence<float> in = view.sample(p, rest, a.v, w);
        const std::array<float, 4> spread = view.spread(in);
        const std::array<Rgb, 4> parts = band_.parts(k);
        Rgb value;
        float pdf = 0;
        for (p = 0; p < 4; ++p) {
            value += spread[p] * parts[p];
            pdf += spread[p] * shares[p];
        }
        if (!(pdf > 0)) return {};
        const Vec3f across = std::cos(in.phi) * outward_ + std::sin(in.phi) * around_;
        return {in.sinTheta * spot_.tangent + in.cosTheta * across, value * (1 / pdf), true};
    }

    /// The way of light that leaves, or comes in, along `direction`: from the axis, and nothing
    /// counts before it is out of the hair. The hair itself would be met at once, its ribbon being
    /// where the axis is.
    Ray leaving(Vec3f direction) const {
        const float along = dot(direction, spot_.segment);
        const float sine = std::sqrt(std::max(0.0F, 1 - along * along));
        return {spot_.axis, direction, spot_.radius / std::max(sine, 0.05F)};
    }

private:
    float sineOf(Vec3f direction) const {
        return std::clamp(dot(direction, spot_.tangent), -1.0F, 1.0F);
    }
    static float cosineOf(float sine) { return std::sqrt(std::max(0.0F, 1 - sine * sine)); }

    /// The direction normal to the hair that is nearest to the eye's.
    static Vec3f outwardOf(Vec3f tangent, Vec3f toEye) {
        const Vec3f across = toEye - dot(toEye, tangent) * tangent;
        const float size = length(across);
        return size > 1e-4F ? across / size : anyNormal(tangent);
    }

    const FibreModel<float>& model_;
    const HairSpot& spot_;
    Places places_;
    Vec3f outward_, around_;
    float sinOut_, cosOut_;
    HairBand band_;
};

}  // namespace kushi
