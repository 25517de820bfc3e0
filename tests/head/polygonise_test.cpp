// SPDX-License-Identifier: Apache-2.0
#include "head/polygonise.h"

#include "head/refine.h"

#include <algorithm>
#include <cmath>
#include <numbers>

#include <gtest/gtest.h>

namespace kushi {
namespace {

Grid evenGrid(double size, double spacing) {
    const std::vector<double> planes = gradedPlanes({{-size, spacing}, {size, spacing}});
    return {planes, planes, gradedPlanes({{spacing / 2, spacing}, {size, spacing}})};
}

double volume(const Mesh& mesh) {
    double sixfold = 0;
    for (const auto& [a, b, c] : mesh.triangles) {
        const auto& v = mesh.vertices;
        sixfold += dot(v[a].as<double>(), cross(v[b].as<double>(), v[c].as<double>()));
    }
    return sixfold / 6;
}

long eulerNumber(const Mesh& mesh) {
    return static_cast<long>(mesh.vertices.size()) - static_cast<long>(mesh.triangles.size()) / 2;
}

double sphere(Vec3d p) {
    return length(p) - 2;
}

double torus(Vec3d p) {
    return std::hypot(std::hypot(p.x, p.z) - 2, p.y) - 0.7;
}

const Fineness fine = {
    .maxTurn = 0.15, .maxError = 0.01, .minEdge = [](Vec3d) { return 0.05; }, .rounds = 4};

TEST(Polygonise, PlanesFollowTheSpacingWanted) {
    const std::vector<double> planes = gradedPlanes({{0, 1}, {4, 1}, {6, 0.5}, {8, 0.5}});
    EXPECT_DOUBLE_EQ(planes[1] - planes[0], 1);
    EXPECT_GE(planes.back(), 8);
    for (std::size_t i = 1; i < planes.size(); ++i) {
        EXPECT_LE(planes[i] - planes[i - 1], 1);
        EXPECT_GE(planes[i] - planes[i - 1], 0.5);
    }
}

TEST(Polygonise, PutsTheVerticesOfASphereOnTheSphere) {
    HalfSurface half = polygonise(sphere, evenGrid(2.9, 0.3));
    refine(sphere, fine, half);
    const Mesh mesh = mirrored(sphere, fine, half);
    EXPECT_EQ(eulerNumber(mesh), 2);
    for (std::size_t i = 0; i < mesh.vertices.size(); ++i) {
        ASSERT_NEAR(length(mesh.vertices[i]), 2, 1e-4F);
        ASSERT_NEAR(dot(mesh.vertices[i], mesh.normals[i]), 2, 1e-3F);
    }
    EXPECT_NEAR(volume(mesh), 4 * std::numbers::pi / 3 * 8, 0.2);
}

TEST(Polygonise, KeepsTheHoleOfATorus) {
    HalfSurface half = polygonise(torus, evenGrid(3.5, 0.25));
    refine(torus, fine, half);
    const Mesh mesh = mirrored(torus, fine, half);
    EXPECT_EQ(eulerNumber(mesh), 0);
    const double exact = 2 * std::numbers::pi * std::numbers::pi * 2 * 0.7 * 0.7;
    EXPECT_NEAR(volume(mesh), exact, 0.02 * exact);
}

// Two drops that nearly touch: the grid meets the saddle between them in every position.
TEST(Polygonise, LeavesNoEdgeWithMoreThanTwoTriangles) {
    for (int i = 0; i < 20; ++i) {
        const double apart = 1.0 + 0.01 * i;
        const Field drops = [apart](Vec3d p) {
            const double a = length(p - Vec3d{apart, apart, 0.3}) - 1.4;
            const double b = length(p + Vec3d{apart, apart, -0.3}) - 1.4;
            return a * b - 0.02;
        };
        const HalfSurface half = polygonise(drops, evenGrid(3.1, 0.23));
        std::vector<std::pair<std::uint32_t, std::uint32_t>> sides;
        for (const auto& t : half.triangles) {
            for (std::size_t c = 0; c < 3; ++c)
                sides.emplace_back(t[c], t[(c + 1) % 3]);
        }
        std::ranges::sort(sides);
        EXPECT_EQ(std::ranges::adjacent_find(sides), sides.end()) << apart;
    }
}

TEST(Refine, SplitsEdgesUntilTheSurfaceBendsLittleAcrossThem) {
    HalfSurface half = polygonise(sphere, evenGrid(2.9, 0.6));
    const std::size_t before = half.triangles.size();
    refine(sphere, fine, half);
    EXPECT_GT(half.triangles.size(), 4 * before);
    for (const auto& t : half.triangles) {
        for (std::size_t c = 0; c < 3; ++c) {
            const double edge = length(half.points[t[c]] - half.points[t[(c + 1) % 3]]);
            EXPECT_LT(edge / 2, 2 * fine.maxTurn);
        }
    }
}

}  // namespace
}  // namespace kushi
