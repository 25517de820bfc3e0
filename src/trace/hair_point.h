// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "shading/fibre_model.h"
#include "trace/axes.h"
#include "trace/ray_scene.h"
#include "trace/sampler.h"

#include <array>

namespace kushi {

/// A direction that light was followed along, and what that makes of it.
struct Turn {
    Vec3f direction;
    Rgb weight;     ///< response / pdf
    float pdf = 0;  ///< 1/sr
};

/// Light from one direction.
struct Response {
    Rgb value;      ///< f |cos|
    float pdf = 0;  ///< with which sample() gives that direction, 1/sr
};

/// A place on a hair that a ray has met.
struct HairSpot {
    Vec3f axis;        ///< m, on the hair's axis
    Vec3f tangent;     ///< unit, interpolated between nodes
    Vec3f segment;     ///< unit, of the straight segment
    float radius = 0;  ///< m
    float h = 0;       ///< across, as fibreResponse() has it
    Rgb absorption;
};

/// How light is scattered there towards the eye.
class HairPoint {
public:
    /// toEye   unit
    /// wanted  what a unit of each colour is worth; lobes are sampled accordingly
    HairPoint(const FibreModel<float>& model, const HairSpot& spot, Vec3f toEye, Rgb wanted)
        : spot_(spot),
          outward_(outwardOf(spot.tangent, toEye)),
          around_(cross(spot.tangent, outward_)),
          view_(model, spot.h, std::clamp(dot(toEye, spot.tangent), -1.0F, 1.0F),
                cosineOf(dot(toEye, spot.tangent))) {
        const auto red = view_.attenuations(spot.absorption.r);
        const auto green = view_.attenuations(spot.absorption.g);
        const auto blue = view_.attenuations(spot.absorption.b);
        float sum = 0;
        for (std::size_t p = 0; p < 4; ++p) {
            parts_[p] = {red[p], green[p], blue[p]};
            shares_[p] = luminance(wanted * parts_[p]);
            sum += shares_[p];
        }
        for (float& share : shares_)
            share = sum > 0 ? share / sum : 0.25F;
    }

    Response response(Vec3f in) const {
        const float sine = std::clamp(dot(in, spot_.tangent), -1.0F, 1.0F);
        return respond({sine, cosineOf(sine), std::atan2(dot(in, around_), dot(in, outward_))});
    }

    Turn sample(Pair a, float w) const {
        std::size_t p = 0;
        float before = 0;
        while (p < 3 && a.u >= before + shares_[p])
            before += shares_[p++];
        // What is left of u is uniform again.
        const float rest = std::clamp((a.u - before) / shares_[p], 0.0F, 1 - 0x1p-24F);
        const FibreIncidence<float> in = view_.sample(p, rest, a.v, w);
        const Vec3f direction =
            in.sinTheta * spot_.tangent +
            in.cosTheta * (std::cos(in.phi) * outward_ + std::sin(in.phi) * around_);
        const Response found = respond(in);
        if (!(found.pdf > 0)) return {};
        return {direction, found.value * (1 / found.pdf), found.pdf};
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
    static float cosineOf(float sine) { return std::sqrt(std::max(0.0F, 1 - sine * sine)); }

    /// The direction normal to the hair that is nearest to the eye's.
    static Vec3f outwardOf(Vec3f tangent, Vec3f toEye) {
        const Vec3f across = toEye - dot(toEye, tangent) * tangent;
        const float size = length(across);
        return size > 1e-4F ? across / size : anyNormal(tangent);
    }

    Response respond(FibreIncidence<float> in) const {
        const std::array<float, 4> spread = view_.spread(in);
        Response result;
        for (std::size_t p = 0; p < 4; ++p) {
            result.value += spread[p] * parts_[p];
            result.pdf += spread[p] * shares_[p];
        }
        return result;
    }

    const HairSpot& spot_;
    Vec3f outward_, around_;
    FibreView<float> view_;
    std::array<Rgb, 4> parts_{};     // A_p
    std::array<float, 4> shares_{};  // probabilities of the lobes
};

}  // namespace kushi
