// SPDX-License-Identifier: Apache-2.0
// The anisotropic shading of Anjyo, Usami & Kurihara 1992, which Usami & Anjyo 1992 use: Blinn's
// specular model on a cylinder too thin to be seen.
#include "shading/color_all.h"
#include "shading/strand_finder.h"

#include <kushi/shade.h>

#include <algorithm>
#include <cmath>

namespace kushi {

namespace {

/// sin of the angle between two unit vectors.
float sine(Vec3f a, Vec3f b) {
    const float cosine = dot(a, b);
    return std::sqrt(std::max(0.0F, 1 - cosine * cosine));
}

/// S = (1 - (t.H)^2)^(n/2): of all normals of a cylinder along t, the one nearest to H has
/// N.H = sin(t, H).
float highlight(Vec3f tangent, Vec3f toLight, Vec3f toEye, float shininess) {
    const Vec3f sum = toLight + toEye;
    const float size = length(sum);
    if (size < 1e-4F) return 0;
    return std::pow(sine(tangent, sum / size), shininess);
}

/// Share of a light that reaches a node: all on the body's side towards the light, none on the
/// other and on the inside of the hair there.
float reaching(const HairLook& look, Vec3f outward, Vec3f toLight) {
    if (!look.body) return 1;
    const float t = std::clamp((dot(outward, toLight) + 0.5F) / 0.9F, 0.0F, 1.0F);
    return t * t * (3 - 2 * t);
}

Rgb shadeNode(Vec3f tangent, Vec3f outward, Vec3f toEye, Rgb color, const Lights& lights,
              const HairLook& look) {
    Rgb sum = look.ambient * (lights.ambient * color);
    for (const Light& light : lights.distant) {
        const float diffuse = look.diffuse * sine(tangent, light.direction);
        const float specular =
            look.specular * highlight(tangent, light.direction, toEye, look.shininess);
        sum += reaching(look, outward, light.direction) * light.color *
               (diffuse * color + specular * look.specularColor);
    }
    return sum;
}

}  // namespace

NodeColors nodeColors(const Strands& strands, const Lights& lights, const HairLook& look,
                      Vec3f eye) {
    return [=, &strands](std::span<const std::uint32_t> nodes, std::span<Rgb> colors) {
        StrandFinder finder(strands);
        for (std::size_t i = 0; i < nodes.size(); ++i) {
            const std::uint32_t node = nodes[i];
            finder.turnTo(node);
            const Vec3f place = strands.nodes[node];
            const Rgb color = strands.colors.empty() ? look.color : strands.colors[node];
            const Vec3f outward =
                look.body ? look.body->normal(place.as<double>()).as<float>() : Vec3f{};
            colors[i] = shadeNode(finder.tangent(node), outward, directionBetween(place, eye),
                                  color, lights, look);
        }
    };
}

void shade(const Strands& strands, const Lights& lights, const HairLook& look, Vec3f eye,
           std::span<Rgb> colors, int threads) {
    colorAll(nodeColors(strands, lights, look, eye), colors, threads);
}

}  // namespace kushi
