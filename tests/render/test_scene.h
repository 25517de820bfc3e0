// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <kushi/draw.h>

#include <cmath>
#include <vector>

namespace kushi::test {

inline constexpr Rgb black = {0, 0, 0};
inline constexpr Rgb white = {1, 1, 1};
inline constexpr Rgb red = {1, 0, 0};
inline constexpr Rgb green = {0, 1, 0};
inline constexpr Rgb blue = {0, 0, 1};

/// 100 m before the plane z = 0, in which a metre is a pixel; the origin is in the picture's
/// middle, x points to the right, y up, z to the camera.
inline Camera pixelCamera(int height) {
    return {.eye = {0, 0, 100},
            .target = {},
            .verticalFieldOfView = static_cast<float>(2 * std::atan(0.5 * height / 100))};
}

/// Strands with one colour per node.
struct Hairs {
    Strands strands;
    std::vector<Rgb> colors;

    void add(const std::vector<Vec3f>& nodes, const std::vector<Rgb>& nodeColors) {
        strands.add(nodes, strands.size());
        colors.insert(colors.end(), nodeColors.begin(), nodeColors.end());
    }
    void add(const std::vector<Vec3f>& nodes, Rgb color) {
        add(nodes, std::vector<Rgb>(nodes.size(), color));
    }
};

/// Adds the rectangle between two corners, at constant z.
inline void addRectangle(Mesh& mesh, Vec3f low, Vec3f high, Rgb color) {
    const auto first = static_cast<std::uint32_t>(mesh.vertices.size());
    for (const Vec3f corner :
         {low, Vec3f{high.x, low.y, low.z}, Vec3f{high.x, high.y, low.z}, {low.x, high.y, low.z}}) {
        mesh.vertices.push_back(corner);
        mesh.normals.push_back({0, 0, 1});
        mesh.colors.push_back(color);
    }
    mesh.triangles.push_back({first, first + 1, first + 2});
    mesh.triangles.push_back({first, first + 2, first + 3});
}

inline Image drawn(const Hairs& hairs, const Mesh& mesh, const DrawOptions& options) {
    return draw(hairs.strands, hairs.colors, mesh, pixelCamera(options.height), options);
}

/// The sum of a picture's red.
inline double redOf(const Image& image) {
    double sum = 0;
    for (const Rgb pixel : image.pixels)
        sum += pixel.r;
    return sum;
}

}  // namespace kushi::test
