// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "geometry/axes.h"
#include "trace/hair_point.h"

#include <numbers>

namespace kushi {

/// A place on the head that a ray has met, from either side.
struct SkinSpot {
    Vec3f place;    ///< m
    Vec3f normal;   ///< unit, interpolated, on the eye's side
    Vec3f surface;  ///< unit, of the triangle, on the eye's side
    Rgb albedo;     ///< in [0, 1]
};

/// Lambert's matt surface under a gloss: Trowbridge and Reitz's distribution of facets (GGX) with
/// Smith's shadowing. Fresnel's share, Schlick's formula for the angle of the eye, goes to the
/// gloss, the rest to what is below, so that never more comes back than arrives.
class SkinPoint {
public:
    /// gloss, width  as in TraceLook
    SkinPoint(const SkinSpot& spot, Vec3f toEye, Rgb wanted, float gloss, float width)
        : spot_(spot), axes_(spot.normal), out_(axes_.toLocal(toEye)), width_(width) {
        out_.z = std::max(out_.z, 1e-4F);
        const float grazing = 1 - std::min(out_.z, 1.0F);
        const float square = grazing * grazing;
        gloss_ = gloss > 0 ? gloss + (1 - gloss) * square * square * grazing : 0;
        const float mirrored = gloss_ * luminance(wanted);
        const float matt = (1 - gloss_) * luminance(wanted * spot.albedo);
        share_ = mirrored + matt > 0 ? mirrored / (mirrored + matt) : 0;
    }

    Response response(Vec3f in) const { return respond(axes_.toLocal(in)); }

    Turn sample(Pair a, float w) const {
        const Vec3f in = w < share_ ? mirror(facet(a)) : cosineLobe(a);
        if (!(in.z > 0)) return {};
        const Response found = respond(in);
        if (!(found.pdf > 0)) return {};
        return {axes_.toWorld(in), found.value * (1 / found.pdf), true};
    }

    Ray leaving(Vec3f direction) const {
        return {spot_.place + 1e-5F * spot_.surface, direction, 0};
    }

private:
    static constexpr float pi = std::numbers::pi_v<float>;

    static Vec3f cosineLobe(Pair a) {
        const float radius = std::sqrt(a.u);
        return {radius * std::cos(2 * pi * a.v), radius * std::sin(2 * pi * a.v),
                std::sqrt(1 - a.u)};
    }

    Vec3f mirror(Vec3f facet) const { return 2 * dot(out_, facet) * facet - out_; }

    /// A facet's normal, as often as it is seen from the eye: on a stretched hemisphere, half way
    /// to a point of a cap (Dupuy and Benyoub 2023).
    Vec3f facet(Pair a) const {
        const Vec3f stretched = normalized(Vec3f{width_ * out_.x, width_ * out_.y, out_.z});
        const float turn = 2 * pi * a.u;
        const float z = (1 - a.v) * (1 + stretched.z) - stretched.z;
        const float radius = std::sqrt(std::max(0.0F, 1 - z * z));
        const Vec3f n = stretched + Vec3f{radius * std::cos(turn), radius * std::sin(turn), z};
        return normalized(Vec3f{width_ * n.x, width_ * n.y, std::max(1e-6F, n.z)});
    }

    /// Smith's lambda.
    float hidden(Vec3f direction) const {
        const float z2 = direction.z * direction.z;
        const float slope = std::max(0.0F, 1 - z2) / std::max(z2, 1e-12F);
        return (std::sqrt(1 + width_ * width_ * slope) - 1) / 2;
    }

    Response respond(Vec3f in) const {
        if (!(in.z > 0)) return {};
        const float lambert = in.z / pi;
        Response result = {(1 - gloss_) * lambert * spot_.albedo, (1 - share_) * lambert};
        if (gloss_ > 0) {
            const Vec3f facet = normalized(in + out_);
            const float w2 = width_ * width_;
            const float t = facet.z * facet.z * (w2 - 1) + 1;
            const float facets = w2 / (pi * t * t);
            const float outHidden = hidden(out_);
            const float density = facets / (4 * out_.z * (1 + outHidden));
            const float value = gloss_ * facets / (4 * out_.z * (1 + outHidden + hidden(in)));
            result.value += Rgb{value, value, value};
            result.pdf += share_ * density;
        }
        return result;
    }

    const SkinSpot& spot_;
    Axes axes_;
    Vec3f out_;
    float width_;
    float gloss_ = 0;  // Fresnel's share
    float share_ = 0;  // probability of sampling the gloss
};

}  // namespace kushi
