// SPDX-License-Identifier: Apache-2.0
#include <kushi/shadows.h>

#include <algorithm>

namespace kushi {

namespace {

constexpr float skinAbove = 0.001F;  // m
// Of the fibres that light meets on its way to the skin some send it on.
constexpr float blocked = 0.6F;

/// reach  called with a vertex and the shares of the distant lights, that reach it, 1 unless it
///        says so; returns that of the light from everywhere
template <class Reach>
std::vector<Rgb> matt(const Mesh& mesh, const Lights& lights, std::span<const Rgb> albedo,
                      Reach&& reach) {
    std::vector<Rgb> colors;
    colors.reserve(mesh.normals.size());
    std::vector<float> reaching(lights.distant.size(), 1.0F);
    for (std::size_t i = 0; i < mesh.normals.size(); ++i) {
        Rgb light = lights.ambient * reach(i, reaching);
        for (std::size_t j = 0; j < reaching.size(); ++j) {
            const float facing = std::max(0.0F, dot(mesh.normals[i], lights.distant[j].direction));
            light += lights.distant[j].color * (facing * reaching[j]);
        }
        colors.push_back(albedo[i] * light);
    }
    return colors;
}

}  // namespace

std::vector<Rgb> shadeMatt(const Mesh& mesh, const Lights& lights, Rgb albedo) {
    return shadeMatt(mesh, lights, std::vector<Rgb>(mesh.normals.size(), albedo));
}

std::vector<Rgb> shadeMatt(const Mesh& mesh, const Lights& lights, std::span<const Rgb> albedo) {
    return matt(mesh, lights, albedo, [](std::size_t, std::span<float>) { return 1.0F; });
}

std::vector<Rgb> shadeMatt(const Mesh& mesh, const Lights& lights, std::span<const Rgb> albedo,
                           const Shadows& shadows) {
    return matt(mesh, lights, albedo, [&](std::size_t i, std::span<float> reaching) {
        const Vec3f normal = mesh.normals[i];
        return shadows.onSkin(mesh.vertices[i] + skinAbove * normal, normal, blocked, reaching);
    });
}

}  // namespace kushi
