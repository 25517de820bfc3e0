// SPDX-License-Identifier: Apache-2.0
//
// Damaged meshes: the readers must return, and what they return must hold together.
#include "io/damage.h"
#include "io/mesh_file.h"
#include "io/mesh_samples.h"
#include "io/place_mesh.h"
#include "io/weld.h"

#include <algorithm>

#include <gtest/gtest.h>

namespace kushi {
namespace {

using Parse = Result<Faces> (*)(std::string_view bytes, const std::string& file);

void expectConsistent(Faces faces) {
    for (const Vec3d point : faces.points)
        ASSERT_TRUE(isFinite(point));
    for (const Faces::Triangle& triangle : faces.triangles) {
        for (const Faces::Corner corner : triangle) {
            ASSERT_LT(corner.point, faces.points.size());
            ASSERT_TRUE(corner.normal == Faces::none || corner.normal < faces.normals.size());
        }
    }
    if (!placeMesh(faces, {}, 0.01).empty()) return;
    const Mesh mesh = weld(faces);
    ASSERT_EQ(mesh.vertices.size(), mesh.normals.size());
    ASSERT_EQ(mesh.groups.size(), faces.groups.empty() ? 0 : mesh.triangles.size());
    ASSERT_EQ(mesh.uvs.size(), faces.uvs.empty() ? 0 : mesh.triangles.size());
    for (std::size_t i = 0; i < mesh.vertices.size(); ++i)
        ASSERT_TRUE(isFinite(mesh.vertices[i]) && isFinite(mesh.normals[i]));
}

class MeshMutation : public testing::TestWithParam<std::pair<std::string, std::string>> {};

TEST_P(MeshMutation, FilesOfAnyDamageAreReadOrRefused) {
    const auto& [name, valid] = GetParam();
    const Parse parse = name.ends_with(".obj")   ? parseObjMesh
                        : name.ends_with(".ply") ? parsePlyMesh
                        : name.ends_with(".stl") ? parseStlMesh
                                                 : parseGltfMesh;
    test::Dice dice(1992);
    int refused = 0;
    constexpr int trials = 4000;
    for (int i = 0; i < trials; ++i) {
        SCOPED_TRACE("trial " + std::to_string(i));
        const Result<Faces> faces = parse(test::mutated(valid, dice), "mutated");
        if (faces) {
            expectConsistent(*faces);
        } else {
            ++refused;
            ASSERT_EQ(faces.problems().size(), 1U);
            ASSERT_FALSE(faces.problems().front().message.empty());
            ASSERT_EQ(faces.problems().front().file, "mutated");
        }
    }
    // Else the damage does not reach the checks.
    EXPECT_GT(refused, trials / 10);
    EXPECT_LT(refused, trials);
}

std::string nameOf(const testing::TestParamInfo<std::pair<std::string, std::string>>& file) {
    std::string name = file.param.first;
    std::ranges::replace(name, '.', '_');
    return name;
}

INSTANTIATE_TEST_SUITE_P(Formats, MeshMutation, testing::ValuesIn(test::tetraFiles()), nameOf);

}  // namespace
}  // namespace kushi
