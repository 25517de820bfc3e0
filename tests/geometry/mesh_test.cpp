// SPDX-License-Identifier: Apache-2.0
#include <kushi/mesh.h>

#include <map>
#include <numbers>

#include <gtest/gtest.h>

namespace kushi {
namespace {

const Ellipsoid egg = {{0.1, 0.2, 0.3}, {0.1, 0.12, 0.08}, 0.3};

TEST(EllipsoidMesh, IsClosedAndOrientedAlike) {
    const Mesh mesh = ellipsoidMesh(egg, 24);
    std::map<std::pair<std::uint32_t, std::uint32_t>, int> edges;
    for (const auto& t : mesh.triangles) {
        for (std::size_t k = 0; k < 3; ++k)
            ++edges[{t[k], t[(k + 1) % 3]}];
    }
    for (const auto& [edge, times] : edges) {
        EXPECT_EQ(times, 1);
        EXPECT_EQ(edges.count({edge.second, edge.first}), 1U);
    }
}

TEST(EllipsoidMesh, HasTheVolumeOfTheEllipsoidWithNormalsOutwards) {
    const Mesh mesh = ellipsoidMesh(egg, 96);
    double sixVolumes = 0;
    for (const auto& [a, b, c] : mesh.triangles) {
        sixVolumes += dot(mesh.vertices[a].as<double>(),
                          cross(mesh.vertices[b].as<double>(), mesh.vertices[c].as<double>()));
    }
    const double exact = 4.0 / 3 * std::numbers::pi * 0.1 * 0.12 * 0.08;
    EXPECT_NEAR(sixVolumes / 6, exact, 0.002 * exact);
}

TEST(ComputeNormals, AgreesWithTheEllipsoidsOwn) {
    Mesh mesh = ellipsoidMesh(egg, 96);
    const std::vector<Vec3f> exact = mesh.normals;
    computeNormals(mesh);
    for (std::size_t i = 0; i < exact.size(); ++i)
        EXPECT_GT(dot(exact[i], mesh.normals[i]), 0.999F);
}

}  // namespace
}  // namespace kushi
