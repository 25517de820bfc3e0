// SPDX-License-Identifier: Apache-2.0
#include "shading/color_all.h"
#include "shading/fibre_lanes.h"
#include "shading/strand_finder.h"
#include "shading/strand_tilt.h"

#include <kushi/pigment.h>
#include <kushi/shadows.h>

#include <algorithm>
#include <cmath>
#include <memory>

namespace kushi {

namespace {

/// The pigment of one node, channel by channel.
struct Pigment {
    std::array<float, 3> absorption{};
    std::array<FarField::Albedo, 3> albedo;
};

/// Fills batches with nodes, and takes colours out of them.
class FibreShading {
public:
    FibreShading(const Strands& strands, const Shadows& shadows, const FibreScene& scene, Vec3f eye)
        : strands_(strands),
          shadows_(shadows),
          scene_(scene),
          eye_(eye),
          batch_(scene.lights.distant.size()),
          passages_(scene.lights.distant.size()),
          finder_(strands),
          pigment_(pigmentOf(color_ = scene.look.color)) {}

    void shade(std::span<const std::uint32_t> nodes, std::span<Rgb> colors) {
        for (std::size_t begin = 0; begin < nodes.size(); begin += FibreBatch::most) {
            batch_.count = std::min(FibreBatch::most, nodes.size() - begin);
            for (std::size_t i = 0; i < batch_.count; ++i)
                put(i, nodes[begin + i]);
            scatterLanes(scene_, batch_);
            for (std::size_t i = 0; i < batch_.count; ++i)
                colors[begin + i] = {batch_.colors[0][i], batch_.colors[1][i], batch_.colors[2][i]};
        }
    }

private:
    Pigment pigmentOf(Rgb color) const {
        const Rgb sigma = absorptionOfColor(color, scene_.look.fibre.azimuthal);
        Pigment pigment;
        pigment.absorption = {sigma.r, sigma.g, sigma.b};
        for (std::size_t c = 0; c < 3; ++c)
            pigment.albedo[c] = scene_.far.albedo(pigment.absorption[c]);
        return pigment;
    }

    void put(std::size_t i, std::uint32_t node) {
        if (finder_.turnTo(node))
            tilt_ = scene_.look.tiltVariation * strandTilt(strands_, finder_.strand());
        const Rgb color = strands_.colors.empty() ? scene_.look.color : strands_.colors[node];
        if (color != color_) pigment_ = pigmentOf(color_ = color);
        const Vec3f tangent = finder_.tangent(node);
        const Vec3f place = strands_.nodes[node];
        const Vec3f toEye = directionBetween(place, eye_);
        const Shadows::Sky sky = shadows_.at(place, toEye, passages_);

        const auto sineTo = [&](Vec3f direction) {
            return std::clamp(dot(tangent, direction), -1.0F, 1.0F);
        };
        batch_.sinOut[i] = sineTo(toEye);
        batch_.tilt[i] = tilt_;
        batch_.hereFree[i] = sky.here.free;
        batch_.hereCrossings[i] = sky.here.crossings;
        batch_.beyondFree[i] = sky.beyond.free;
        batch_.beyondCrossings[i] = sky.beyond.crossings;
        for (std::size_t c = 0; c < 3; ++c) {
            batch_.absorption[c][i] = pigment_.absorption[c];
            batch_.forward[c][i] = pigment_.albedo[c].forward;
            batch_.backward[c][i] = pigment_.albedo[c].backward;
            batch_.local[c][i] = pigment_.albedo[c].local;
        }
        for (std::size_t j = 0; j < passages_.size(); ++j) {
            const Vec3f direction = scene_.lights.distant[j].direction;
            FibreBatch::LightRows& rows = batch_.lights[j];
            rows.sinIn[i] = sineTo(direction);
            rows.facing[i] = dot(toEye, direction);
            rows.free[i] = passages_[j].free;
            rows.crossings[i] = passages_[j].crossings;
        }
    }

    const Strands& strands_;
    const Shadows& shadows_;
    const FibreScene& scene_;
    Vec3f eye_;
    FibreBatch batch_;
    std::vector<Passage> passages_;
    StrandFinder finder_;
    float tilt_ = 0;
    Rgb color_;
    Pigment pigment_;
};

}  // namespace

NodeColors nodeColors(const Strands& strands, const Lights& lights, const Shadows& shadows,
                      const FibreLook& look, Vec3f eye) {
    const auto scene = std::make_shared<const FibreScene>(look, lights);
    return [=, &strands, &shadows](std::span<const std::uint32_t> nodes, std::span<Rgb> colors) {
        FibreShading(strands, shadows, *scene, eye).shade(nodes, colors);
    };
}

void shade(const Strands& strands, const Lights& lights, const Shadows& shadows,
           const FibreLook& look, Vec3f eye, std::span<Rgb> colors, int threads) {
    colorAll(nodeColors(strands, lights, shadows, look, eye), colors, threads);
}

}  // namespace kushi
