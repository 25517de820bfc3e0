// SPDX-License-Identifier: Apache-2.0
#include "core/parallel.h"
#include "shading/strand_tilt.h"
#include "shading/tangents.h"
#include "trace/path.h"

namespace kushi {

namespace {

std::vector<float> diametersOf(const Strands& strands, float usual) {
    std::vector<float> diameters = strands.diameters;
    if (diameters.empty()) diameters.assign(strands.nodes.size(), usual);
    return diameters;
}

/// The unit vector along `a`, or `other` if it has no length.
Vec3f unitOr(Vec3f a, Vec3f other) {
    const float size = length(a);
    return size > 0 && std::isfinite(size) ? a / size : other;
}

float withinOne(float x) {
    return x > 0 ? std::min(x, 1.0F) : 0;  // 0 for what is not a number, too
}

}  // namespace

World::World(const Strands& strands, const Mesh& head, std::span<const Rgb> skin,
             const Lights& lights, const TraceLook& look, int threads)
    : nodes_(strands.nodes.size()),
      head_(head),
      skin_(skin),
      look_(look),
      fibre_(look.fibre),
      sky_(lights),
      rays_(strands, diametersOf(strands, look.diameter), head, threads) {
    const double roughness = look.fibre.azimuthal;
    const Rgb usual = absorptionOfColor(look.color, roughness);
    parallelFor(strands.size(), 256, threads, [&](std::size_t begin, std::size_t end) {
        for (std::size_t i = begin; i < end; ++i) {
            const std::size_t first = strands.offsets[i];
            const float tilt = look.tiltVariation * strandTilt(strands, i);
            forEachTangent(strands.strand(i), [&](std::size_t j, Vec3f tangent) {
                const std::size_t n = first + j;
                const float diameter =
                    strands.diameters.empty() ? look.diameter : strands.diameters[n];
                // Neighbours mostly have the same colour.
                const Rgb absorption = strands.colors.empty() ? usual
                                       : j > 0 && strands.colors[n] == strands.colors[n - 1]
                                           ? nodes_[n - 1].absorption
                                           : absorptionOfColor(strands.colors[n], roughness);
                nodes_[n] = {strands.nodes[n], diameter / 2, tangent, absorption, tilt};
            });
        }
    });
}

HairSpot World::hairAt(const Meeting& met, const Ray& ray) const {
    const Node& a = nodes_[met.which];
    const Node& b = nodes_[met.which + 1];
    const float u = met.u;
    HairSpot spot;
    spot.axis = a.place + u * (b.place - a.place);
    spot.segment = normalized(b.place - a.place);
    spot.tangent = unitOr((1 - u) * a.tangent + u * b.tangent, spot.segment);
    spot.radius = (1 - u) * a.radius + u * b.radius;
    spot.tilt = a.tilt;
    spot.absorption = (1 - u) * a.absorption + u * b.absorption;
    // How far beside the axis the ray runs.
    const Vec3f across = unitOr(cross(ray.direction, spot.segment), {});
    spot.h = std::clamp(dot(spot.axis - ray.origin, across) / spot.radius, -1.0F, 1.0F);
    return spot;
}

SkinSpot World::skinAt(const Meeting& met, const Ray& ray) const {
    const auto [i, j, k] = head_.triangles[met.which];
    const float w = 1 - met.u - met.v;
    const auto mixed = [&](auto a, auto b, auto c) { return w * a + met.u * b + met.v * c; };
    const Vec3f a = head_.vertices[i];
    const Vec3f b = head_.vertices[j];
    const Vec3f c = head_.vertices[k];
    SkinSpot spot;
    spot.place = mixed(a, b, c);
    spot.surface = unitOr(cross(b - a, c - a), -ray.direction);
    spot.normal = unitOr(mixed(head_.normals[i], head_.normals[j], head_.normals[k]), spot.surface);
    if (dot(spot.surface, ray.direction) > 0) {
        spot.surface = -spot.surface;
        spot.normal = -spot.normal;
    }
    if (dot(spot.normal, ray.direction) > 0) spot.normal = spot.surface;
    const Rgb albedo = skin_.empty() ? Rgb{0.5F, 0.5F, 0.5F} : mixed(skin_[i], skin_[j], skin_[k]);
    spot.albedo = {withinOne(albedo.r), withinOne(albedo.g), withinOne(albedo.b)};
    return spot;
}

}  // namespace kushi
