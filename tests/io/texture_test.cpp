// SPDX-License-Identifier: Apache-2.0
#include "io/mesh_samples.h"
#include "io/temp_folder.h"

#include <kushi/head.h>
#include <kushi/mesh_io.h>

#include <cmath>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

namespace kushi {
namespace {

using test::Gltf;
using testing::ElementsAre;
using testing::HasSubstr;

Result<Mesh> readBytes(const std::string& name, const std::string& bytes) {
    const test::TempFolder folder;
    test::writeBytes(folder.path(name), bytes);
    return readMesh(folder.path(name), {.unit = {}, .origin = MeshOrigin::File, .offset = {}});
}

Mesh meshOf(const std::string& name, const std::string& bytes) {
    Result<Mesh> mesh = readBytes(name, bytes);
    EXPECT_TRUE(mesh.ok()) << toString(mesh.problems()[0]);
    return mesh ? *mesh : Mesh{};
}

const std::string corners = "v 0 0 0\nv 10 0 0\nv 0 30 0\nv 0 0 9\n";

std::vector<std::string> namesOf(const Mesh& mesh, std::size_t triangle) {
    return mesh.groupNames.at(mesh.groups.at(triangle));
}

TEST(ObjTexture, StaysWithTheCornersAndSplitsNoVertex) {
    const Mesh mesh = meshOf("a.obj", corners +
                                          "vt 0.25 0.5\nvt 1 0\nvt 0 1 0\nvt 0.75\n"
                                          "f 1/1 3/2 2/3\nf 1/4 2/-1 4/-4\nf 1 4 3\nf 2 3 4\n");
    EXPECT_EQ(mesh.vertices.size(), 4U);
    ASSERT_EQ(mesh.uvs.size(), 4U);
    EXPECT_THAT(mesh.uvs[0],
                ElementsAre(TexturePoint{0.25F, 0.5F}, TexturePoint{1, 0}, TexturePoint{0, 1}));
    EXPECT_THAT(mesh.uvs[1], ElementsAre(TexturePoint{0.75F, 0}, TexturePoint{0.75F, 0},
                                         TexturePoint{0.25F, 0.5F}));
    EXPECT_TRUE(std::isnan(mesh.uvs[2][0].u));
}

TEST(ObjTexture, GoesRoundWithTrianglesThatAreTurned) {
    const Mesh mesh = meshOf("a.obj", corners +
                                          "vt 0.1 0\nvt 0.2 0\nvt 0.3 0\nvt 0.4 0\n"
                                          "f 1/1 2/2 3/3\nf 1/1 4/4 2/2\nf 1/1 3/3 4/4\n"
                                          "f 2/2 4/4 3/3\n");
    for (std::size_t i = 0; i < 4; ++i) {
        for (std::size_t k = 0; k < 3; ++k) {
            // Corners of the file by where they lie: its x is Kushi's -z, its z Kushi's x.
            const Vec3f p = mesh.vertices[mesh.triangles[i][k]];
            const float expected = p.z < 0 ? 0.2F : (p.y > 0 ? 0.3F : (p.x > 0 ? 0.4F : 0.1F));
            EXPECT_EQ(mesh.uvs[i][k].u, expected);
        }
    }
}

TEST(ObjTexture, IsLeftEmptyWithoutAny) {
    EXPECT_TRUE(meshOf("a.obj", test::objTetra()).uvs.empty());
    EXPECT_TRUE(meshOf("a.ply", test::textPlyTetra()).uvs.empty());
    EXPECT_TRUE(meshOf("a.ply", test::textPlyTetra()).groups.empty());
}

// Vertices of a square with a place in the texture each, by the names that programs give them.
std::string texturedPly(const std::string& u, const std::string& v) {
    return "ply\nformat ascii 1.0\nelement vertex 5\nproperty float x\nproperty float " + u +
           "\nproperty float y\nproperty float z\nproperty float " + v +
           "\nelement face 3\nproperty list uchar int vertex_indices\nend_header\n"
           "0 0.1 0 0 0.6\n10 0.2 0 0 0.7\n10 0.3 30 0 0.8\n0 0.4 30 0 0.9\n0 0.5 0 9 1\n"
           "4 0 3 2 1\n3 0 1 4\n3 0 4 3\n";
}

// The texture's place of each corner, by where that lies in the file.
std::vector<std::pair<Vec3f, TexturePoint>> placesIn(const Mesh& mesh) {
    std::vector<std::pair<Vec3f, TexturePoint>> places;
    for (std::size_t i = 0; i < mesh.uvs.size(); ++i) {
        for (std::size_t k = 0; k < 3; ++k) {
            const Vec3f p = mesh.vertices[mesh.triangles[i][k]];
            places.emplace_back(100 * Vec3f{-p.z, p.y, p.x}, mesh.uvs[i][k]);
        }
    }
    return places;
}

TEST(PlyTexture, IsReadFromVertices) {
    for (const auto& [u, v] :
         {std::pair("s", "t"), std::pair("u", "v"), std::pair("texture_u", "texture_v")}) {
        const Mesh mesh = meshOf("a.ply", texturedPly(u, v));
        ASSERT_EQ(mesh.uvs.size(), 4U) << u;
        for (const auto& [place, at] : placesIn(mesh)) {
            const float expected = place.z > 1   ? 0.5F
                                   : place.y > 1 ? (place.x > 1 ? 0.3F : 0.4F)
                                                 : (place.x > 1 ? 0.2F : 0.1F);
            EXPECT_EQ(at.u, expected);
            EXPECT_FLOAT_EQ(at.v, expected + 0.5F);
        }
    }
    EXPECT_TRUE(meshOf("a.ply", texturedPly("s", "v")).uvs.empty());
}

TEST(PlyTexture, IsReadFromFaces) {
    const std::string head =
        "ply\nformat ascii 1.0\nelement vertex 4\nproperty float x\nproperty float y\n"
        "property float z\nelement face 4\nproperty list uchar float texcoord\n"
        "property list uchar int vertex_indices\nend_header\n"
        "0 0 0\n10 0 0\n0 30 0\n0 0 9\n";
    const Mesh mesh = meshOf("a.ply", head +
                                          "6 0.1 0 0.3 0 0.2 0 3 0 2 1\n"
                                          "6 0.5 1 0.6 1 0.8 1 3 0 1 3\n"
                                          "4 0 0 0 0 3 0 3 2\n0 3 1 2 3\n");
    ASSERT_EQ(mesh.uvs.size(), 4U);
    for (const auto& [place, at] : placesIn(mesh)) {
        if (std::isnan(at.u)) continue;
        const float low = place.x > 1 ? 0.2F : place.y > 1 ? 0.3F : 0.1F;
        const float high = place.x > 1 ? 0.6F : place.z > 1 ? 0.8F : 0.5F;
        EXPECT_EQ(at.u, at.v == 1 ? high : low);
    }
    EXPECT_FALSE(std::isnan(mesh.uvs[1][2].u));
    EXPECT_TRUE(std::isnan(mesh.uvs[2][0].u));
    EXPECT_TRUE(std::isnan(mesh.uvs[3][0].u));
}

TEST(ObjTexture, RefusesWordsForNumbers) {
    const Result<Mesh> mesh = readBytes("a.obj", corners + "vt 0 up\nf 1 2 3\n");
    ASSERT_FALSE(mesh.ok());
    EXPECT_THAT(toString(mesh.problems()[0]), HasSubstr(":5: error: expected vt and numbers"));
}

TEST(ObjGroups, AreObjectsGroupsAndMaterials) {
    const Mesh mesh = meshOf("a.obj", corners +
                                          "f 1 3 2\no Big Head\nusemtl my skin\nf 1 2 4\n"
                                          "g scalp left\nf 1 4 3\ng\nusemtl\no Big Head\n"
                                          "usemtl my skin\nf 2 3 4\n");
    ASSERT_EQ(mesh.groups.size(), 4U);
    EXPECT_THAT(namesOf(mesh, 0), ElementsAre());
    EXPECT_THAT(namesOf(mesh, 1), ElementsAre("Big Head", "my skin"));
    EXPECT_THAT(namesOf(mesh, 2), ElementsAre("Big Head", "left", "my skin", "scalp"));
    EXPECT_EQ(mesh.groups[3], mesh.groups[1]);
    EXPECT_EQ(mesh.groupNames.size(), 3U);
}

TEST(ObjGroups, BelongToEachTriangleOfAPolygon) {
    const Mesh mesh =
        meshOf("a.obj", corners + "v 10 30 0\ng a\nf 1 3 5 2\ng b\nf 1 2 4\nf 1 4 3\n");
    EXPECT_THAT(mesh.groups, ElementsAre(0, 0, 1, 1));
}

TEST(ObjGroups, MayBeTooMany) {
    std::string obj = corners;
    for (int i = 0; i < 65536; ++i)
        obj += "g " + std::to_string(i) + "\nf 1 2 3\n";
    const Result<Mesh> mesh = readBytes("a.obj", obj);
    ASSERT_FALSE(mesh.ok());
    EXPECT_THAT(mesh.problems()[0].message, HasSubstr("more than 65535 groups"));
}

// The corners' texture coordinates behind the tetrahedron's bytes.
Gltf textured() {
    Gltf gltf;
    gltf.primitive = R"({"attributes":{"POSITION":0,"TEXCOORD_0":2},"indices":1,"material":1})";
    gltf.accessors.back() = ',';
    gltf.accessors += R"({"bufferView":2,"componentType":5126,"count":4,"type":"VEC2"}])";
    gltf.views.back() = ',';
    gltf.views += R"({"buffer":0,"byteOffset":72,"byteLength":32}])";
    gltf.buffer += std::string(test::Bytes().f32({0, 0, 0.25, 0.75, 1, 1, 0.5, 0}));
    gltf.nodes = R"([{"mesh":0,"name":"Head"}])";
    gltf.extra = R"("materials":[{"name":"eyes"},{"name":"skin"}],)";
    return gltf;
}

TEST(GltfTexture, IsTurnedToCountFromBelow) {
    const Mesh mesh = meshOf("a.glb", textured().binary());
    ASSERT_EQ(mesh.uvs.size(), 4U);
    // Corners 0, 2 and 1 of the file.
    EXPECT_THAT(mesh.uvs[0],
                ElementsAre(TexturePoint{0, 1}, TexturePoint{1, 0}, TexturePoint{0.25F, 0.25F}));
    EXPECT_EQ(mesh.vertices.size(), 4U);
}

TEST(GltfGroups, AreNodesMeshesAndMaterials) {
    const Mesh mesh = meshOf("a.gltf", textured().text());
    ASSERT_EQ(mesh.groups.size(), 4U);
    EXPECT_THAT(namesOf(mesh, 3), ElementsAre("Head", "skin"));
    EXPECT_THAT(namesOf(meshOf("a.glb", Gltf().binary()), 0), ElementsAre());
}

TEST(GltfTexture, RefusesAnotherNumberThanOfPositions) {
    Gltf gltf = textured();
    const std::string whole = R"("count":4,"type":"VEC2")";
    gltf.accessors.replace(gltf.accessors.find(whole), whole.size(), R"("count":3,"type":"VEC2")");
    const Result<Mesh> mesh = readBytes("a.glb", gltf.binary());
    ASSERT_FALSE(mesh.ok());
    EXPECT_THAT(mesh.problems()[0].message,
                HasSubstr("not as many texture coordinates as positions"));
}

TEST(Mannequin, HasTheScalpForAGroup) {
    const Mesh head = mannequin();
    const std::vector<std::uint8_t> grows = scalpTriangles(head);
    ASSERT_EQ(head.groups.size(), grows.size());
    for (std::size_t i = 0; i < grows.size(); ++i)
        ASSERT_EQ(head.groupNames.at(head.groups[i]).size(), grows[i]);
    EXPECT_THAT(head.groupNames, ElementsAre(ElementsAre(), ElementsAre("scalp")));
}

}  // namespace
}  // namespace kushi
