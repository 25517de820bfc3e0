// SPDX-License-Identifier: Apache-2.0
#include <kushi/shadows.h>

#include <algorithm>
#include <cmath>

namespace kushi {

namespace {

constexpr float skinAbove = 0.001F;  // m
// Of the fibres that light meets on its way to the skin some send it on.
constexpr float blocked = 0.6F;

float reaching(Passage passage) {
    return passage.free * std::exp(-blocked * passage.crossings);
}

}  // namespace

std::vector<Rgb> shadeMatt(const Mesh& mesh, const Lights& lights, Rgb albedo) {
    return shadeMatt(mesh, lights, std::vector<Rgb>(mesh.normals.size(), albedo));
}

std::vector<Rgb> shadeMatt(const Mesh& mesh, const Lights& lights, std::span<const Rgb> albedo) {
    std::vector<Rgb> colors;
    colors.reserve(mesh.normals.size());
    for (std::size_t i = 0; i < mesh.normals.size(); ++i) {
        const Vec3f normal = mesh.normals[i];
        Rgb light = lights.ambient;
        for (const Light& distant : lights.distant) {
            light += distant.color * std::max(0.0F, dot(normal, distant.direction));
        }
        colors.push_back(albedo[i] * light);
    }
    return colors;
}

std::vector<Rgb> shadeMatt(const Mesh& mesh, const Lights& lights, std::span<const Rgb> albedo,
                           const Shadows& shadows) {
    std::vector<Rgb> colors;
    colors.reserve(mesh.normals.size());
    std::vector<Passage> passages(lights.distant.size());
    for (std::size_t i = 0; i < mesh.normals.size(); ++i) {
        const Vec3f normal = mesh.normals[i];
        const Vec3f place = mesh.vertices[i] + skinAbove * normal;
        const Shadows::Sky sky = shadows.at(place, normal, passages);
        Rgb light = lights.ambient * reaching(sky.here);
        for (std::size_t j = 0; j < passages.size(); ++j) {
            const float facing = std::max(0.0F, dot(normal, lights.distant[j].direction));
            light += lights.distant[j].color * (facing * reaching(passages[j]));
        }
        colors.push_back(albedo[i] * light);
    }
    return colors;
}

}  // namespace kushi
