// SPDX-License-Identifier: Apache-2.0
#include <kushi/shade.h>

#include <algorithm>

namespace kushi {

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

}  // namespace kushi
