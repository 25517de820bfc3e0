// SPDX-License-Identifier: Apache-2.0
#include "wig.h"

#include <kushi/head.h>
#include <kushi/shade.h>

#include <algorithm>
#include <cmath>
#include <numbers>

namespace kushi::bench {

namespace {

constexpr int segmentCount = 20;
constexpr double strandLength = 0.25;  // m
constexpr double spacing = 0.01065;    // rad between roots, for 50,000 of them

/// A strand that leaves the ellipsoid along its normal, turns downwards and follows the surface.
std::vector<Vec3f> strandFrom(const Ellipsoid& ellipsoid, EllipsoidAngles root) {
    std::vector<Vec3f> nodes;
    Vec3d at = ellipsoid.point(root);
    Vec3d direction = ellipsoid.normal(at);
    for (int i = 0; i <= segmentCount; ++i) {
        nodes.push_back(at.as<float>());
        direction = normalized(direction + Vec3d{0, -0.35, 0});
        const Vec3d normal = ellipsoid.normal(at);
        const double inwards = -dot(direction, normal);
        if (ellipsoid.implicit(at) < 0.25 && inwards > 0) direction += inwards * normal;
        at += strandLength / segmentCount * normalized(direction);
    }
    return nodes;
}

/// Roots in rows, evenly spread, where hair grows.
Strands wig(const Ellipsoid& ellipsoid) {
    const auto grows = [](EllipsoidAngles root) {
        return std::ranges::any_of(hairRegion(),
                                   [&](const AngleRange& range) { return range.contains(root); });
    };
    Strands strands;
    for (int row = 0; row < static_cast<int>(std::numbers::pi / spacing); ++row) {
        const double theta = (row + 0.5) * spacing;
        const int columns = static_cast<int>(2 * std::numbers::pi * std::sin(theta) / spacing);
        for (int i = 0; i < columns; ++i) {
            const EllipsoidAngles root = {theta, 2 * std::numbers::pi * i / columns};
            if (grows(root)) strands.add(strandFrom(ellipsoid, root), strands.size());
        }
    }
    return strands;
}

}  // namespace

Wig mannequinWig() {
    Wig scene;
    scene.strands = wig(headEllipsoid());
    scene.head = mannequin();
    const Lights lights = studioLights();
    scene.head.colors = shadeMatt(scene.head, lights, {0.6F, 0.6F, 0.6F});
    scene.camera = frame(boundsOf(scene.strands.nodes), {.yaw = 0.6, .pitch = 0.1}, 1);
    scene.camera.eye = scene.camera.target + 0.65F * (scene.camera.eye - scene.camera.target);
    scene.colors.resize(scene.strands.nodes.size());
    shade(scene.strands, lights, HairLook{}, scene.camera.eye, scene.colors);
    return scene;
}

}  // namespace kushi::bench
