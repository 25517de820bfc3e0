// SPDX-License-Identifier: Apache-2.0
#include "io/mesh_samples.h"
#include "io/temp_folder.h"

#include <kushi/head.h>
#include <kushi/mesh_io.h>

#include <algorithm>
#include <cmath>
#include <cstdio>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

namespace kushi {
namespace {

using test::Bytes;
using test::Gltf;
using test::TempFolder;

constexpr MeshPlacement asIs = {.unit = {}, .origin = MeshOrigin::File, .offset = {}};

Mesh readBytes(const std::string& name, const std::string& bytes,
               const MeshPlacement& placement = asIs) {
    const TempFolder folder;
    test::writeBytes(folder.path(name), bytes);
    Result<Mesh> mesh = readMesh(folder.path(name), placement);
    EXPECT_TRUE(mesh.ok()) << toString(mesh.problems().front());
    return mesh ? *mesh : Mesh{};
}

void expectNear(Vec3f found, Vec3d expected, double tolerance = 1e-7) {
    EXPECT_LE(length(found.as<double>() - expected), tolerance)
        << found.x << ' ' << found.y << ' ' << found.z << " instead of " << expected.x << ' '
        << expected.y << ' ' << expected.z;
}

void expectWhole(const Mesh& mesh) {
    ASSERT_EQ(mesh.normals.size(), mesh.vertices.size());
    EXPECT_TRUE(mesh.colors.empty());
    for (const Vec3f normal : mesh.normals)
        EXPECT_NEAR(length(normal), 1, 1e-5);
    for (const auto& triangle : mesh.triangles) {
        for (const std::uint32_t corner : triangle)
            ASSERT_LT(corner, mesh.vertices.size());
    }
}

Vec3d twiceArea(const Mesh& mesh, std::size_t triangle) {
    const auto& [a, b, c] = mesh.triangles[triangle];
    const Vec3f origin = mesh.vertices[a];
    return cross((mesh.vertices[b] - origin).as<double>(),
                 (mesh.vertices[c] - origin).as<double>());
}

double area(const Mesh& mesh) {
    double sum = 0;
    for (std::size_t i = 0; i < mesh.triangles.size(); ++i)
        sum += length(twiceArea(mesh, i)) / 2;
    return sum;
}

// The face looks along the file's z, so that its x is the person's left: Kushi's -z.
TEST(ReadMesh, GivesTheSameMeshFromEveryFormat) {
    for (const auto& [name, bytes] : test::tetraFiles()) {
        SCOPED_TRACE(name);
        const Mesh mesh = readBytes(name, bytes);
        expectWhole(mesh);
        ASSERT_EQ(mesh.vertices.size(), 4U);
        // In the order in which the faces name them.
        expectNear(mesh.vertices[0], {0, 0, 0});
        expectNear(mesh.vertices[1], {0, 0.3, 0});
        expectNear(mesh.vertices[2], {0, 0, -0.1});
        expectNear(mesh.vertices[3], {0.09, 0, 0});
        EXPECT_THAT(
            mesh.triangles,
            testing::ElementsAre(testing::ElementsAre(0, 1, 2), testing::ElementsAre(0, 2, 3),
                                 testing::ElementsAre(0, 3, 1), testing::ElementsAre(2, 1, 3)));
        // Three faces meet at the origin: of 150 cm2 facing back, 45 down, 135 to the right.
        expectNear(mesh.normals[0], normalized(Vec3d{-150, -45, 135}), 1e-6);
    }
}

TEST(ReadMesh, TakesExtensionsInCapitals) {
    EXPECT_TRUE(isMeshPath("a/Head.OBJ"));
    EXPECT_TRUE(isMeshPath("head.GlB"));
    EXPECT_FALSE(isMeshPath("head.fbx"));
    EXPECT_FALSE(isMeshPath("obj"));
    EXPECT_EQ(readBytes("Head.OBJ", test::objTetra()).vertices.size(), 4U);
}

TEST(ReadMesh, ConvertsUnits) {
    MeshPlacement placement = asIs;
    for (const auto& [unit, height] : {std::pair(0.01, 0.3), {0.0254, 0.762}, {0.05, 1.5}}) {
        placement.unit = unit;
        expectNear(readBytes("t.obj", test::objTetra(), placement).vertices[1], {0, height, 0});
    }
    placement.unit = 5;  // 30 cm in glTF's own metres
    expectNear(readBytes("t.glb", Gltf().binary(), placement).vertices[1], {0, 1.5, 0});
}

TEST(ReadMesh, TurnsTheAxesOfTheFile) {
    // Corner 2, file (10, 20, 30), for every way up and front.
    const std::string obj =
        "v 0 0 0\nv 10 20 30\nv 100 0 0\nv 0 110 0\nv 0 0 120\n"
        "f 1 2 3\nf 1 2 4\nf 1 2 5\n";
    struct Turn {
        Vec3d up, front, found;
    };
    for (const auto& [up, front, found] : {
             Turn{{0, 1, 0}, {0, 0, 1}, {0.3, 0.2, -0.1}},
             Turn{{0, 1, 0}, {1, 0, 0}, {0.1, 0.2, 0.3}},
             Turn{{0, 0, 1}, {0, -1, 0}, {-0.2, 0.3, -0.1}},  // Blender
             Turn{{0, 0, 1}, {1, 0, 0}, {0.1, 0.3, -0.2}},
             Turn{{-1, 0, 0}, {0, 0, -1}, {-0.3, -0.1, 0.2}},
         }) {
        MeshPlacement placement = asIs;
        placement.up = up;
        placement.front = front;
        expectNear(readBytes("a.obj", obj, placement).vertices[1], found);
    }
}

TEST(ReadMesh, MovesTheCrownToTheMannequins) {
    const Mesh mannequin = kushi::mannequin();
    std::string obj;
    for (const Vec3f v : mannequin.vertices) {
        char line[128];
        std::snprintf(line, sizeof line, "v %.7f %.7f %.7f\n", 1000 * v.x + 5000, 1000 * v.y - 300,
                      1000 * v.z + 77);
        obj += line;
    }
    for (const auto& [a, b, c] : mannequin.triangles) {
        obj += "f " + std::to_string(a + 1) + ' ' + std::to_string(b + 1) + ' ' +
               std::to_string(c + 1) + '\n';
    }
    const TempFolder folder;
    test::writeBytes(folder.path("m.obj"), obj);
    MeshPlacement placement = {.unit = 0.001, .front = {1, 0, 0}, .offset = {}};
    const auto mesh = readMesh(folder.path("m.obj"), placement);
    ASSERT_TRUE(mesh.ok());
    ASSERT_EQ(mesh->triangles.size(), mannequin.triangles.size());
    for (std::size_t i = 0; i < mesh->triangles.size(); ++i) {
        for (std::size_t k = 0; k < 3; ++k) {
            const Vec3f there = mannequin.vertices[mannequin.triangles[i][k]];
            const Vec3f here = mesh->vertices[mesh->triangles[i][k]];
            ASSERT_LT(length(here - there), 1e-3F) << i;
        }
    }
    EXPECT_EQ(scalpTriangles(*mesh).size(), mesh->triangles.size());

    placement.offset = {0.01, -0.02, 0.03};
    const auto moved = readMesh(folder.path("m.obj"), placement);
    ASSERT_TRUE(moved.ok());
    expectNear(moved->vertices[0], mesh->vertices[0].as<double>() + placement.offset, 1e-6);
}

TEST(ReadMesh, CutsPolygonsIntoTriangles) {
    // An L of five squares of 10 cm, turned both ways round, and far from flat corners on one side.
    for (const char* face : {"f 1 2 3 4 5 6\n", "f 6 5 4 3 2 1\n"}) {
        const Mesh mesh = readBytes(
            "l.obj",
            std::string("v 0 0 0\nv 30 0 0\nv 30 10 0\nv 10 10 0\nv 10 30 0\nv 0 30 0\n") + face);
        ASSERT_EQ(mesh.triangles.size(), 4U);
        EXPECT_NEAR(area(mesh), 0.05, 1e-7);
        for (std::size_t i = 1; i < 4; ++i) {
            EXPECT_GT(dot(twiceArea(mesh, i), twiceArea(mesh, 0)), 0) << i;
        }
    }
}

/// A cube of 20 cm with one normal for each face.
std::string cube(bool normals, double sign = 1, bool reversed = false) {
    std::string obj;
    for (int i = 0; i < 8; ++i) {
        obj += "v " + std::to_string(20 * (i & 1)) + ' ' + std::to_string(10 * (i & 2)) + ' ' +
               std::to_string(5 * (i & 4)) + '\n';
    }
    const int corners[6][4] = {{0, 4, 6, 2}, {1, 3, 7, 5}, {0, 1, 5, 4},
                               {2, 6, 7, 3}, {0, 2, 3, 1}, {4, 5, 7, 6}};
    for (int face = 0; face < 6; ++face) {
        double n[3] = {0, 0, 0};
        n[face / 2] = sign * (face % 2 == 0 ? -2 : 2);  // of any length
        obj += "vn " + std::to_string(n[0]) + ' ' + std::to_string(n[1]) + ' ' +
               std::to_string(n[2]) + "\nf";
        for (int k = 0; k < 4; ++k) {
            obj += ' ' + std::to_string(corners[face][reversed ? 3 - k : k] + 1);
            if (normals) obj += "//" + std::to_string(face + 1);
        }
        obj += '\n';
    }
    return obj;
}

TEST(ReadMesh, KeepsNormalsAndSmoothsWhereThereAreNone) {
    const Mesh hard = readBytes("hard.obj", cube(true));
    EXPECT_EQ(hard.vertices.size(), 24U);
    const Mesh smooth = readBytes("smooth.obj", cube(false));
    EXPECT_EQ(smooth.vertices.size(), 8U);
    for (const Mesh& mesh : {hard, smooth}) {
        expectWhole(mesh);
        EXPECT_EQ(mesh.triangles.size(), 12U);
        EXPECT_NEAR(area(mesh), 6 * 0.04, 1e-6);
    }
    for (const Vec3f normal : hard.normals) {
        EXPECT_NEAR(std::max({std::abs(normal.x), std::abs(normal.y), std::abs(normal.z)}), 1,
                    1e-6);
    }
    // A corner without a normal, or with one of no direction: then none is believed.
    std::string some = cube(true);
    some.replace(some.find("//6"), 3, "");
    EXPECT_EQ(readBytes("some.obj", some).vertices.size(), 8U);
    std::string zero = cube(true);
    zero.replace(zero.find("vn -2.000000"), 12, "vn 0.000000");
    EXPECT_EQ(readBytes("zero.obj", zero).vertices.size(), 8U);
}

TEST(ReadMesh, TurnsEverythingOutwards) {
    for (const bool normals : {false, true}) {
        for (const double sign : {1.0, -1.0}) {
            for (const bool reversed : {false, true}) {
                const Mesh mesh = readBytes("cube.obj", cube(normals, sign, reversed));
                const Vec3f middle = {0.1F, 0.1F, -0.1F};
                for (std::size_t i = 0; i < mesh.triangles.size(); ++i) {
                    const std::uint32_t corner = mesh.triangles[i][0];
                    const Vec3f outwards = mesh.vertices[corner] - middle;
                    EXPECT_GT(dot(twiceArea(mesh, i), outwards.as<double>()), 0);
                    EXPECT_GT(dot(mesh.normals[corner], outwards), 0);
                }
            }
        }
    }
}

TEST(ReadMesh, LeavesOutWhatIsNoSurface) {
    // A vertex on no face would make it 1 km high; one face has no area; lines and points.
    const Mesh mesh = readBytes("t.obj", test::objTetra() +
                                             "v 0 100000 0\nv 5 0 0\nf 1 2 6\n"
                                             "f 1 2 2\nl 1 5\np 5\n");
    EXPECT_EQ(mesh.vertices.size(), 4U);
    EXPECT_EQ(mesh.triangles.size(), 4U);
}

TEST(ReadMesh, TakesTheDialectsOfPly) {
    std::string text = test::textPlyTetra();
    text.replace(text.find("vertex_indices"), 14, "vertex_index");
    EXPECT_EQ(readBytes("a.ply", text).triangles.size(), 4U);

    const Mesh quad =
        readBytes("quad.ply",
                  "ply\nformat ascii 1.0\nelement vertex 4\nproperty double x\nproperty double y\n"
                  "property double z\nproperty float nx\nproperty float ny\nproperty float nz\n"
                  "element face 1\nproperty list uchar uint vertex_indices\nelement edge 1\n"
                  "property int vertex1\nproperty int vertex2\nend_header\n"
                  "0 0 0 0 0 1\n20 0 0 0 0 1\n20 20 0 0 0 1\n0 20 0 0 0 1\n4 0 1 2 3\n0 1\n");
    EXPECT_EQ(quad.triangles.size(), 2U);
    for (const Vec3f normal : quad.normals)
        expectNear(normal, {1, 0, 0});
}

TEST(ReadMesh, TakesSeveralSolidsOfAnStl) {
    std::string text = test::textStlTetra();
    for (char& c : text)
        c = static_cast<char>(std::toupper(static_cast<unsigned char>(c)));
    EXPECT_EQ(readBytes("a.stl", text + test::textStlTetra()).triangles.size(), 8U);
}

TEST(ReadGltf, PutsMeshesWhereTheirNodesAre) {
    // A quarter turn about y (z becomes x), then doubled along y, then moved: the order of glTF.
    Gltf gltf;
    gltf.nodes = R"([{"children":[1,2],"translation":[1,2,3]},)"
                 R"({"mesh":0,"rotation":[0,0.70710678,0,0.70710678],"scale":[1,2,1]},)"
                 R"({"mesh":0,"matrix":[1,0,0,0, 0,1,0,0, 0,0,1,0, 0,0,-7,1]}])";
    const Mesh mesh = readBytes("t.gltf", gltf.text());
    ASSERT_EQ(mesh.vertices.size(), 8U);
    // File (x, y, z) is (z, y, -x) here.
    expectNear(mesh.vertices[0], {3, 2, -1}, 1e-6);
    expectNear(mesh.vertices[1], {3, 2.6, -1}, 1e-6);
    expectNear(mesh.vertices[2], {3 - 0.1, 2, -1}, 1e-6);
    expectNear(mesh.vertices[3], {3, 2, -1.09}, 1e-6);
    expectNear(mesh.vertices[4], {-4, 2, -1}, 1e-6);
    expectNear(mesh.vertices[7], {-4 + 0.09, 2, -1}, 1e-6);
}

TEST(ReadGltf, TurnsMirroredMeshesRound) {
    Gltf gltf;
    gltf.nodes = R"([{"children":[1,2]},{"mesh":0,"scale":[-1,1,1]},{"mesh":0}])";
    const Mesh mesh = readBytes("t.gltf", gltf.text());
    ASSERT_EQ(mesh.triangles.size(), 8U);
    // The first face of either lies in the file's xy plane and looks along its -z: our -x.
    EXPECT_LT(twiceArea(mesh, 0).x, 0);
    EXPECT_LT(twiceArea(mesh, 4).x, 0);
}

TEST(ReadGltf, TakesStripsFansAndPlainLists) {
    const std::string square = R"([{"bufferView":0,"componentType":5126,"count":4,"type":"VEC3"}])";
    const std::string strip = Bytes().f32({0, 0, 0, 0.2, 0, 0, 0, 0.2, 0, 0.2, 0.2, 0}).zeros(24);
    const std::string fan = Bytes().f32({0, 0, 0, 0.2, 0, 0, 0.2, 0.2, 0, 0, 0.2, 0}).zeros(24);
    for (const auto& [mode, bytes] : {std::pair("5", strip), {"6", fan}}) {
        Gltf gltf;
        gltf.accessors = square;
        gltf.primitive = R"({"attributes":{"POSITION":0},"mode":)" + std::string(mode) + "}";
        gltf.buffer = bytes;
        const Mesh mesh = readBytes("s.gltf", gltf.text());
        ASSERT_EQ(mesh.triangles.size(), 2U) << mode;
        EXPECT_NEAR(area(mesh), 0.04, 1e-7);
        EXPECT_GT(dot(twiceArea(mesh, 0), twiceArea(mesh, 1)), 0);
    }
    Gltf gltf;
    gltf.primitive = R"({"attributes":{"POSITION":0}})";
    EXPECT_EQ(readBytes("s.gltf", gltf.text()).triangles.size(), 1U);
}

TEST(ReadGltf, TakesNumbersOfEveryTypeAndStride) {
    // Corners in 16 bits, two bytes of padding after each; indices in 8 bits.
    Gltf gltf;
    gltf.buffer = Bytes()
                      .u16({0, 0, 0, 9, 10000, 0, 0, 9, 0, 30000, 0, 9, 0, 0, 9000, 9})
                      .u8({0, 2, 1, 0, 1, 3, 0, 3, 2, 1, 2, 3});
    gltf.accessors = R"([{"bufferView":0,"componentType":5122,"count":4,"type":"VEC3"},)"
                     R"({"bufferView":1,"componentType":5121,"count":12,"type":"SCALAR"}])";
    gltf.views =
        R"([{"buffer":0,"byteLength":32,"byteStride":8},{"buffer":0,"byteOffset":32,"byteLength":12}])";
    gltf.nodes = R"([{"mesh":0,"scale":[1e-5,1e-5,1e-5]}])";
    const Mesh mesh = readBytes("t.gltf", gltf.text());
    ASSERT_EQ(mesh.vertices.size(), 4U);
    expectNear(mesh.vertices[1], {0, 0.3, 0});

    gltf.accessors.replace(gltf.accessors.find("5122,"), 5, "5122,\"normalized\":true,");
    gltf.nodes = R"([{"mesh":0}])";
    expectNear(readBytes("t.gltf", gltf.text()).vertices[1], {0, 30000 / 32767.0, 0});
}

TEST(ReadGltf, FindsBuffersBesideTheFile) {
    const TempFolder folder;
    test::writeBytes(folder.path("my head.bin"), test::gltfTetraBuffer());
    test::writeBytes(folder.path("t.gltf"), Gltf().json(R"(,"uri":"my%20head.bin")"));
    const auto mesh = readMesh(folder.path("t.gltf"), asIs);
    ASSERT_TRUE(mesh.ok()) << toString(mesh.problems()[0]);
    EXPECT_EQ(mesh->vertices.size(), 4U);
}

TEST(ReadGltf, NeedsNoScene) {
    std::string text = Gltf().text();
    const std::string scene = R"("scene":0,"scenes":[{"nodes":[0]}],)";
    text.erase(text.find(scene), scene.size());
    EXPECT_EQ(readBytes("t.gltf", text).triangles.size(), 4U);
}

// A real head: Debian's libcgal-demo, whose data has to be unpacked by hand.
TEST(ReadMesh, ReadsAHeadOfAnotherProgram) {
    const char* file = std::getenv("KUSHI_TEST_HEAD");
    if (file == nullptr) GTEST_SKIP() << "KUSHI_TEST_HEAD names no mesh of a head";
    MeshPlacement placement;
    Result<Mesh> mesh = readMesh(file, placement);
    ASSERT_TRUE(mesh.ok()) << toString(mesh.problems()[0]);
    expectWhole(*mesh);
    float top = -1;
    for (const Vec3f vertex : mesh->vertices)
        top = std::max(top, vertex.y);
    EXPECT_NEAR(top, 0.1135F, 1e-6F);
}

}  // namespace
}  // namespace kushi
