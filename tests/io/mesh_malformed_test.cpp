// SPDX-License-Identifier: Apache-2.0
//
// Files that are no head, and what must be said of each.
#include "io/mesh_samples.h"
#include "io/temp_folder.h"

#include <kushi/mesh_io.h>

#include <filesystem>
#include <limits>
#include <ostream>

#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <sys/stat.h>

namespace kushi {
namespace {

using test::Bytes;
using test::Gltf;
using test::TempFolder;
using testing::HasSubstr;

struct Malformed {
    std::string name;
    std::string extension;
    std::string bytes;
    std::string message;  // part of it
    int line = 0;
};

std::ostream& operator<<(std::ostream& out, const Malformed& file) {
    return out << file.name << file.extension;
}

std::string with(std::string text, const std::string& what, const std::string& instead) {
    const std::size_t at = text.find(what);
    EXPECT_NE(at, std::string::npos) << what;
    return text.replace(at, what.size(), instead);
}

const std::string someVertices = "v 0 0 0\nv 30 0 0\nv 0 30 0\n";
const double inf = std::numeric_limits<double>::infinity();

std::vector<Malformed> objFiles() {
    const auto obj = [](const std::string& lines) { return someVertices + lines; };
    std::string many = "f";
    for (int i = 0; i <= 1000; ++i)
        many += " 1";
    return {
        {"Empty", ".obj", "", "the file is empty"},
        {"NotObj", ".obj", "ply\nformat ascii 1.0\n", "unknown keyword 'ply'", 1},
        {"Binary", ".obj", test::binaryStlTetra(), "unknown keyword 'solid,'", 1},
        {"NoFaces", ".obj", obj(""), "no faces in 3 vertices; a head is a mesh of faces"},
        {"Strands", ".obj", obj("l 1 2 3\n"), "no faces in 3 vertices"},
        {"NanCoordinate", ".obj", "v 0 nan 0\n", "a position that is not finite", 1},
        {"HugeCoordinate", ".obj", "v 0 1e999 0\n", "a position that is not finite", 1},
        {"CutShort", ".obj", obj("v 1 2"), "expected v and three numbers, found ''", 4},
        {"Word", ".obj", obj("v 1 2 c"), "expected v and three numbers, found 'c'", 4},
        {"VertexZero", ".obj", obj("f 0 1 2\n"), "vertex '0' does not exist; 3 are defined", 4},
        {"VertexTooLarge", ".obj", obj("f 1 2 4\n"), "vertex '4' does not exist", 4},
        {"VertexTooFarBack", ".obj", obj("f -1 -2 -4\n"), "vertex '-4' does not exist", 4},
        {"NormalTooLarge", ".obj", obj("f 1 2 3//1\n"), "normal '1' does not exist; 0 are", 4},
        {"NormalMissing", ".obj", obj("f 1 2 3//\n"), "expected the index of a normal, found ''",
         4},
        {"IndexOfText", ".obj", obj("f 1 2 x\n"), "the index of a vertex, found 'x'", 4},
        {"TwoCorners", ".obj", obj("f 1 2\n"), "a face of 2 corners, expected 3 or more", 4},
        {"ManyCorners", ".obj", obj(many), "a face of more than 1000 corners; triangulate", 4},
        {"Surface", ".obj", obj("surf 0 1 0 1 1\n"), "a free-form curve or surface (surf)", 4},
        {"NoArea", ".obj", obj("v 0 15 0\nf 1 3 4\n"), "no face has an area"},
        {"Flat", ".obj", "v 0 0 0\nv 30 0 0\nv 0 0 30\nf 1 2 3\n", "the mesh is flat"},
        {"Metres", ".obj", "v 0 0 0\nv 0.2 0 0\nv 0 0.25 0\nf 1 2 3\n",
         "the mesh is 0.25 cm high, expected 15 to 250 (a head, or a whole figure); unit = \"m\" "
         "makes it 25"},
        {"Inches", ".obj", "v 0 0 0\nv 1 0 0\nv 0 10 0\nf 1 2 3\n", "unit = \"in\" makes it 25.4"},
        {"MetresOrMillimetres", ".obj", "v 0 0 0\nv 1 0 0\nv 0 1700 0\nf 1 2 3\n",
         "unit = \"mm\" makes it 170"},
        {"OddUnit", ".obj", "v 0 0 0\nv 1 0 0\nv 0 5 0\nf 1 2 3\n", "unit = 5 makes it 25"},
        {"Wide", ".obj", "v 0 0 0\nv 1e30 0 0\nv 0 30 0\nf 1 2 3\n", "cm wide, expected 1000"},
    };
}

std::vector<Malformed> plyFiles() {
    const std::string text = test::textPlyTetra();
    const std::string binary = test::binaryPlyTetra(false);
    return {
        {"NotPly", ".ply", someVertices, "its first line is not 'ply'"},
        {"HeaderCutShort", ".ply", text.substr(0, text.find("element face")), "no 'end_header'", 8},
        {"TextCutShort", ".ply", text.substr(0, text.size() - 10),
         "face 3 (counted from 0) of 4: the file ends before the end of the row", 19},
        {"BinaryCutShort", ".ply", binary.substr(0, binary.size() - 1),
         "face 3 (counted from 0) of 4: the file ends before the end of the row"},
        {"BytesAfterTheEnd", ".ply", binary + "x", "something follows the last row"},
        {"FourBillionVertices", ".ply", with(binary, "vertex 4", "vertex 4000000000"),
         "announces 4000000000 rows of element 'vertex', more than the file has room for"},
        {"FourBillionFaces", ".ply", with(text, "face 4", "face 4000000000"),
         "announces 4000000000 rows of element 'face', more than the file has room for"},
        {"LongList", ".ply", with(text, "0 3 1 2 3", "0 200 1 2 3"), "the row ends before", 20},
        {"NanCoordinate", ".ply", with(text, "10 0 0", "10 nan 0"),
         "vertex 1 (counted from 0) of 4: has a position that is not finite", 14},
        {"IndexTooLarge", ".ply", with(text, "3 1 2 3", "3 1 2 4"),
         "face 3 (counted from 0) of 4: a corner is not the index of one of the 4 vertices", 20},
        {"IndexBelowZero", ".ply", with(text, "3 1 2 3", "3 1 2 -1"), "is not the index", 20},
        {"TwoCorners", ".ply", with(text, "3 1 2 3", "2 1 2"), "has 2 corners, expected 3", 20},
        {"NoHeight", ".ply", with(text, "float y", "float why"), "no properties x, y and z"},
        {"NoIndices", ".ply", with(text, "vertex_indices", "corners"),
         "no list vertex_indices in the element 'face'"},
        {"FacesFirst", ".ply",
         "ply\nformat ascii 1.0\nelement face 1\nproperty list uchar int vertex_indices\n"
         "element vertex 1\nproperty float x\nend_header\n3 0 1 2\n0\n",
         "faces, but no element 'vertex' before them"},
        {"Strands", ".ply",
         "ply\nformat ascii 1.0\nelement vertex 2\nproperty float x\nproperty float y\n"
         "property float z\nelement strand 1\nproperty int nsegs\nend_header\n0 0 0\n0 1 0\n1\n",
         "no faces: this file holds strands"},
        {"Points", ".ply",
         "ply\nformat ascii 1.0\nelement vertex 1\nproperty float x\nproperty float y\n"
         "property float z\nend_header\n0 0 0\n",
         "no faces in 1 vertices"},
    };
}

std::vector<Malformed> stlFiles() {
    const std::string text = test::textStlTetra();
    const std::string binary = test::binaryStlTetra();
    std::string shorter = binary;
    shorter[0] = 'x';
    shorter.pop_back();
    return {
        {"NotStl", ".stl", "v 1 2 3\n", "neither starts with 'solid' nor has the 84 bytes"},
        {"Picture", ".stl", Bytes().text("\x89PNG").zeros(96).u16({7}),
         "bytes after the last facet, or not an STL file: 102 bytes, but a header with 0 facets "
         "asks for 84"},
        {"BinaryCutShort", ".stl", shorter, "283 bytes, but a header with 4 facets asks for 284"},
        {"FourBillionFacets", ".stl", Bytes().zeros(80).u32({0xffffffff}).zeros(50),
         "134 bytes, but a header with 4294967295 facets asks for 214748364834"},
        {"NanCoordinate", ".stl",
         Bytes().zeros(80).u32({1}).f32({0, 0, 0, 0, 0, 0, 1, 0, 0, 0, inf, 0}).u16({0}),
         "facet 0 (counted from 0) has a position that is not finite"},
        {"NoFacets", ".stl", Bytes().zeros(84), "no faces in 0 vertices"},
        {"NoFacetsInText", ".stl", "solid a\nendsolid a\n", "no faces in 0 vertices"},
        {"TextCutShort", ".stl", text.substr(0, text.find("endsolid")),
         "cut short: no 'endsolid' at the end", 29},
        {"FacetCutShort", ".stl", "solid a\nfacet normal 0 0 1\nvertex 1 2 3\nendsolid\n",
         "found 'endsolid', expected 'endfacet' first", 4},
        {"Corners", ".stl", "solid a\nfacet normal 0 0 1\nvertex 1 2 3\nendfacet\nendsolid\n",
         "a facet of 1 vertices, expected 3", 4},
        {"TextNan", ".stl", "solid a\nfacet normal 0 0 1\nvertex 1 -nan 3\n", "not finite", 3},
        {"Word", ".stl", "solid a\nfacet normal 0 0 1\nvertex 1 two 3\n", "found 'two'", 3},
        {"Keyword", ".stl", "solid a\ntriangle\n", "found 'triangle'", 2},
        {"Outside", ".stl", "solid a\nvertex 1 2 3\n", "a vertex outside of a facet", 2},
    };
}

Malformed gltf(const std::string& name, const std::string& what, const std::string& instead,
               const std::string& message) {
    return {name, ".gltf", with(Gltf().text(), what, instead), message};
}

std::vector<Malformed> gltfFiles() {
    const std::string text = Gltf().text();
    const std::string binary = Gltf().binary();
    std::string longer = binary;
    longer[8] = static_cast<char>(longer[8] + 4);
    std::string version = binary;
    version[4] = 1;
    std::string chunk = binary;
    chunk[15] = 1;
    Gltf index;
    index.buffer[70] = 4;
    Gltf nan;
    nan.buffer = Bytes().f32({0, 0, 0, 0.1, 0, 0, 0, inf, 0, 0, 0, 0.09}).zeros(24);
    return {
        {"NotJson", ".gltf", someVertices, "the JSON is malformed or cut short at byte 1 of 26"},
        {"JsonCutShort", ".gltf", text.substr(0, 200), "the JSON is malformed or cut short"},
        {"Array", ".gltf", "[1, 2]", "not a glTF file: no asset version"},
        {"Deep", ".gltf", std::string(100000, '['), "the JSON is malformed or cut short"},
        {"HugeNumber", ".gltf", with(text, "\"count\":4", "\"count\":1e999"), "number that is too"},
        {"JustTheMagic", ".glb", "glTF", "cut short: 4 bytes of a .glb file"},
        {"OldBinary", ".glb", version, "glTF version 1, expected 2"},
        {"BinaryCutShort", ".glb", binary.substr(0, binary.size() - 4), "cut short: "},
        {"BinaryLonger", ".glb", longer, "cut short: "},
        {"BytesAfterTheEnd", ".glb", binary + "xxxx", "bytes after the end: "},
        {"HugeChunk", ".glb", chunk, "chunk 0 (counted from 0) announces 16"},
        {"NoJson", ".glb", with(binary, "JSON", "LSON"), "the first chunk is not JSON"},
        gltf("OldText", "\"2.0\"", "\"1.0\"", "glTF version '1.0', expected 2.0"),
        gltf("Draco", "\"scene\":0", R"("extensionsRequired":["KHR_draco_mesh_compression"])",
             "its mesh is compressed (KHR_draco_mesh_compression); export it without"),
        gltf("NoSuchNode", "[{\"nodes\":[0]}]", "[{\"nodes\":[7]}]", "node 7: does not exist"),
        gltf("NodeOfText", "[{\"nodes\":[0]}]", R"([{"nodes":["a"]}])", "nodes holds what is no"),
        gltf("Circle", R"([{"mesh":0}])", R"([{"mesh":0,"children":[0]}])",
             "node 0: is below two nodes, expected a tree"),
        gltf("NoSuchMesh", R"([{"mesh":0}])", R"([{"mesh":3}])", "mesh 3: does not exist"),
        gltf("Matrix", R"([{"mesh":0}])", R"([{"mesh":0,"matrix":[1]}])", "not an array of 16"),
        gltf("Scale", R"([{"mesh":0}])", R"([{"mesh":0,"scale":[1,1,"a"]}])", "what is no number"),
        gltf("Far", R"([{"mesh":0}])", R"([{"mesh":0,"scale":[1e300,1e300,1]}])", "not finite"),
        gltf("NoMesh", R"([{"mesh":0}])", "[{}]", "no faces in 0 vertices"),
        gltf("NoPosition", "POSITION", "COLOR_0", "a primitive without POSITION"),
        gltf("NoSuchAccessor", "\"POSITION\":0", "\"POSITION\":9", "accessor 9 does not exist"),
        gltf("Points", "\"indices\":1", "\"mode\":0", "no faces in 0 vertices"),
        gltf("Mode", "\"indices\":1", "\"mode\":9", "unknown mode 9"),
        gltf("NormalsShort", "\"POSITION\":0", R"("POSITION":0,"NORMAL":1)",
             "its type is not VEC3"),
        gltf("Type", "VEC3", "VEC2", "accessor 0: its type is not VEC3"),
        gltf("Component", "5126", "5130", "unknown componentType 5130"),
        gltf("CountBelowZero", "\"count\":4", "\"count\":-4", "count is not a whole number from 0"),
        gltf("CountTooLarge", "\"count\":4", "\"count\":5",
             "accessor 0: 5 elements do not fit into the 48 bytes of its bufferView"),
        gltf("FourBillion", "\"count\":4", "\"count\":4294967295", "more than 60000000 vertices"),
        gltf("ManyIndices", "\"count\":12", "\"count\":50000000", "do not fit into the 24 bytes"),
        gltf("Sparse", "\"count\":4", R"("sparse":{},"count":4)", "a sparse accessor"),
        gltf("NoView", "\"bufferView\":0,", "", "its bufferView does not exist"),
        gltf("Stride", "\"byteLength\":48", R"("byteStride":4,"byteLength":48)", "overlap"),
        gltf("ViewTooLong", "\"byteLength\":24", "\"byteLength\":25",
             "reaches past the end of buffer 0, which has 72 bytes"),
        gltf("BufferCutShort", "\"byteLength\":72", "\"byteLength\":73",
             "buffer 0 is cut short: 72 bytes, but byteLength says 73"),
        gltf("NotBase64", ";base64,", ";base64,*", "buffer 0 is not base64"),
        gltf("NoUri", "\"uri\"", "\"url\"", "buffer 0 is cut short: 0 bytes"),
        gltf("Address", "data:application/octet-stream", "https://x.org/a?",
             "buffer 0 lies at 'https://x.org/a?;base64,...', expected a file beside this one"),
        gltf("NoSuchFile", "data:application/octet-stream;base64,", "no", "buffer 0: "),
        {"IndexTooLarge", ".gltf", index.text(), "an index is not that of one of its 4 vertices"},
        {"Infinite", ".gltf", nan.text(), "a position that is not finite"},
    };
}

class MalformedMesh : public testing::TestWithParam<Malformed> {};

TEST_P(MalformedMesh, IsRefusedWithOneClearMessage) {
    const Malformed& file = GetParam();
    const TempFolder folder;
    const std::string path = folder.path(file.name + file.extension);
    test::writeBytes(path, file.bytes);
    const auto mesh = readMesh(path);
    ASSERT_FALSE(mesh.ok());
    ASSERT_EQ(mesh.problems().size(), 1U);
    const Problem& problem = mesh.problems().front();
    EXPECT_THAT(problem.message, HasSubstr(file.message));
    EXPECT_EQ(problem.file, path);
    EXPECT_EQ(problem.line, file.line) << problem.message;
    EXPECT_FALSE(problem.system);
    EXPECT_FALSE(problem.message.ends_with('.'));
}

const auto nameOf = [](const auto& info) { return info.param.name; };
INSTANTIATE_TEST_SUITE_P(Obj, MalformedMesh, testing::ValuesIn(objFiles()), nameOf);
INSTANTIATE_TEST_SUITE_P(Ply, MalformedMesh, testing::ValuesIn(plyFiles()), nameOf);
INSTANTIATE_TEST_SUITE_P(Stl, MalformedMesh, testing::ValuesIn(stlFiles()), nameOf);
INSTANTIATE_TEST_SUITE_P(Gltf, MalformedMesh, testing::ValuesIn(gltfFiles()), nameOf);

void expectProblem(const std::string& path, const std::string& message) {
    const auto mesh = readMesh(path);
    ASSERT_FALSE(mesh.ok());
    ASSERT_EQ(mesh.problems().size(), 1U);
    EXPECT_EQ(mesh.problems()[0].file, path);
    EXPECT_THAT(mesh.problems()[0].message, HasSubstr(message));
}

TEST(ReadMesh, RefusesWhatIsNoFile) {
    const TempFolder folder;
    expectProblem(folder.path("none.obj"), "No such file");
    std::filesystem::create_directory(folder.path("folder.stl"));
    expectProblem(folder.path("folder.stl"), "directory");
    expectProblem(folder.path("head.fbx"), "expected .obj, .ply, .stl, .gltf or .glb");
    ASSERT_EQ(::mkfifo(folder.path("pipe.ply").c_str(), 0600), 0);
    expectProblem(folder.path("pipe.ply"), "a pipe or a device");
}

// A file with a hole costs no disk, but would cost the memory.
TEST(ReadMesh, RefusesHugeFilesBeforeReadingThem) {
    const TempFolder folder;
    test::writeBytes(folder.path("huge.stl"), "solid");
    std::filesystem::resize_file(folder.path("huge.stl"), std::uintmax_t{1} << 40U);
    expectProblem(folder.path("huge.stl"), "has 1099511627776 bytes; at most 1073741824 are read");
}

}  // namespace
}  // namespace kushi
