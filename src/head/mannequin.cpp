// SPDX-License-Identifier: Apache-2.0
#include "head/polygonise.h"
#include "head/refine.h"
#include "head/shape.h"

#include <kushi/head.h>

#include <cmath>

namespace kushi {

namespace {

/// Fine enough not to miss a lip or the rim of an ear; what bends is refined later [cm].
Grid startingGrid() {
    return {gradedPlanes(
                {{-17, 1.2}, {-6, 0.9}, {-4, 0.38}, {0.5, 0.42}, {4, 0.8}, {6, 0.5}, {11, 0.45}}),
            gradedPlanes({{-36, 1.1},
                          {-22, 1.0},
                          {-13, 0.9},
                          {-10, 0.5},
                          {-8, 0.42},
                          {2, 0.4},
                          {4, 0.7},
                          {12.5, 1.0}}),
            gradedPlanes({{0.2, 0.4},
                          {2, 0.42},
                          {4.8, 0.45},
                          {6.2, 0.5},
                          {7, 0.32},
                          {8.3, 0.32},
                          {10, 1.0},
                          {20.5, 1.1}})};
}

/// Detail belongs to face and ears, most of it to the lids and to the parting of the lips [cm].
double finestEdge(Vec3d p) {
    const bool lips = p.x > 6 && std::abs(p.y + 6.45) < 0.4;
    const bool lids = p.x > 5 && std::abs(p.y - 0.2) < 0.9;
    if (lips || lids) return lips ? 0.035 : 0.05;
    return p.y > -12 ? 0.075 : 0.25;
}

}  // namespace

Mesh mannequin() {
    const Field field = mannequinField;
    HalfSurface half = polygonise(field, startingGrid());
    const Fineness fineness = {
        .maxTurn = 0.27, .maxError = 0.025, .minEdge = finestEdge, .rounds = 6};
    refine(field, fineness, half);
    Mesh mesh = mirrored(field, fineness, half);
    for (Vec3f& vertex : mesh.vertices)
        vertex = vertex * 0.01F;
    const std::vector<std::uint8_t> grows = scalpTriangles(mesh);
    mesh.groups.assign(grows.begin(), grows.end());
    mesh.groupNames = {{}, {"scalp"}};
    return mesh;
}

}  // namespace kushi
