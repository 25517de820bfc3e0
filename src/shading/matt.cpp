// SPDX-License-Identifier: Apache-2.0
#include <kushi/shade.h>

#include <algorithm>

namespace kushi {

std::vector<Rgb> shadeMatt(const Mesh& mesh, const Lights& lights, Rgb albedo) {
    std::vector<Rgb> colors;
    colors.reserve(mesh.normals.size());
    for (const Vec3f normal : mesh.normals) {
        Rgb light = lights.ambient;
        for (const Light& distant : lights.distant) {
            light += distant.color * std::max(0.0F, dot(normal, distant.direction));
        }
        colors.push_back(albedo * light);
    }
    return colors;
}

}  // namespace kushi
