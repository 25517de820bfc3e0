// SPDX-License-Identifier: Apache-2.0
//
// Files that are not what they say, and what must be said of each.
#include "io/temp_folder.h"
#include "io/test_bytes.h"

#include <kushi/groom_io.h>

#include <limits>
#include <ostream>
#include <string>
#include <vector>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

namespace kushi {
namespace {

using test::Bytes;
using test::HairHeader;
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

std::string manyProperties() {
    std::string header = "ply\nformat ascii 1.0\nelement vertex 1\n";
    for (int i = 0; i <= 1000; ++i)
        header += "property char p" + std::to_string(i) + "\n";
    return header;
}

Bytes hair(HairHeader header) {
    return header;
}

const std::string hairStart = hair({1, 2, 2, 1});
const double nan = std::numeric_limits<double>::quiet_NaN();
const double inf = std::numeric_limits<double>::infinity();

std::vector<Malformed> hairFiles() {
    return {
        {"Empty", ".hair", "", "the file is empty"},
        {"NotHair", ".hair", "ply\nformat", "starts with 'ply?' instead of 'HAIR'"},
        {"HeaderCutShort", ".hair", "HAIR1234",
         "8 bytes, but the header of a .hair file alone has 128"},
        {"NoPointsArray", ".hair", hair({1, 2, 1, 1}).u16({1}), "no points array"},
        {"UnknownArrays", ".hair", hair({1, 2, 2 + 32, 1}), "array bits 34; the largest is 31"},
        {"FourBillionPoints", ".hair", hair({1, 0xffffffff, 2, 0xfffffffe}),
         "cut short: 128 bytes, but a header with 1 strands and 4294967295 points asks for "
         "51539607668"},
        {"FourBillionStrands", ".hair", hair({0xffffffff, 0xffffffff, 3, 0}),
         "cut short: 128 bytes, but a header with 4294967295 strands"},
        {"PointsCutShort", ".hair", hair({1, 2, 2, 1}).f32({0, 0, 0, 0, 1}),
         "cut short: 148 bytes, but a header with 1 strands and 2 points asks for 152"},
        {"ColorsMissing", ".hair", hair({1, 2, 18, 1}).f32({0, 0, 0, 0, 1, 0}),
         "cut short: 152 bytes, but a header with 1 strands and 2 points asks for 176"},
        {"BytesAfterTheEnd", ".hair", hair({1, 2, 2, 1}).f32({0, 0, 0, 0, 1, 0}).zeros(1),
         "bytes after the last array: 153 bytes, but a header with 1 strands and 2 points asks for "
         "152"},
        {"SegmentsAskForMore", ".hair", hair({1, 2, 3, 1}).u16({2}).f32({0, 0, 0, 0, 1, 0}),
         "its segments ask for 3 points, but the header says 2"},
        {"SegmentsAskForLess", ".hair", hair({1, 2, 3, 1}).u16({0}).f32({0, 0, 0, 0, 1, 0}),
         "its segments ask for 1 points, but the header says 2"},
        {"DefaultSegmentsDisagree", ".hair", hair({1, 2, 2, 2}).f32({0, 0, 0, 0, 1, 0}),
         "1 strands of 2 segments have 3 points, but the header says 2"},
        {"PointsWithoutStrands", ".hair", hair({0, 2, 2, 1}).f32({0, 0, 0, 0, 1, 0}),
         "0 strands of 1 segments have 0 points, but the header says 2"},
        {"NanCoordinate", ".hair", hair({1, 2, 2, 1}).f32({0, 0, 0, 0, nan, 0}),
         "point 1 (counted from 0) has a position that is not finite"},
        {"InfiniteCoordinate", ".hair", hair({1, 2, 2, 1}).f32({0, 0, -inf, 0, 1, 0}),
         "point 0 (counted from 0) has a position that is not finite"},
        {"NanThickness", ".hair", hair({1, 2, 6, 1}).f32({0, 0, 0, 0, 1, 0}).f32({0.01, nan}),
         "point 1 (counted from 0) has a thickness that is not finite or below 0"},
        {"NegativeThickness", ".hair", hair({1, 2, 6, 1}).f32({0, 0, 0, 0, 1, 0}).f32({-1, 1}),
         "point 0 (counted from 0) has a thickness that is not finite or below 0"},
        {"TransparencyAboveOne", ".hair", hair({1, 2, 10, 1}).f32({0, 0, 0, 0, 1, 0}).f32({0, 2}),
         "point 1 (counted from 0) has a transparency that is not between 0 and 1"},
        {"InfiniteColor", ".hair", hair({1, 1, 18, 0}).f32({0, 0, 0}).f32({0, inf, 0}),
         "point 0 (counted from 0) has a colour that is not finite"},
    };
}

const std::string ascii = "ply\nformat ascii 1.0\n";
const std::string vertex = "property float x\nproperty float y\nproperty float z\n";
const std::string twoVertices = ascii + "element vertex 2\n" + vertex;
const std::string strand = "element strand 1\nproperty ushort nsegs\n";
const std::string edges = "property int vertex1\nproperty int vertex2\n";
const std::string twoRows = "end_header\n0 0 0\n0 1 0\n";

std::vector<Malformed> plyHeaders() {
    return {
        {"Empty", ".ply", "", "the file is empty"},
        {"NotPly", ".ply", "HAIR", "not a PLY file: its first line is not 'ply'"},
        {"HeaderCutShort", ".ply", twoVertices, "cut short: the header has no 'end_header'", 6},
        {"NoFormat", ".ply", "ply\nelement vertex 2\n" + vertex + twoRows, "names no format", 6},
        {"UnknownFormat", ".ply", "ply\nformat utf8 1.0\nend_header\n", "unknown format 'utf8'", 2},
        {"UnknownVersion", ".ply", "ply\nformat ascii 2.0\nend_header\n",
         "unknown PLY version '2.0'", 2},
        {"BadCount", ".ply", ascii + "element vertex -3\n", "found the count '-3'", 3},
        {"HugeCount", ".ply", ascii + "element vertex 99999999999999999999\n",
         "found the count '99999999999999999999'", 3},
        {"UnknownType", ".ply", ascii + "element vertex 2\nproperty quad x\n",
         "unknown type 'quad'", 4},
        {"UnknownListType", ".ply", ascii + "element a 2\nproperty list float int x\n",
         "unknown type 'float' for the length of a list", 4},
        {"PropertyBeforeElement", ".ply", ascii + vertex, "a property before the first element", 3},
        {"PropertyWithoutName", ".ply", ascii + "element vertex 2\nproperty float\n",
         "a property without a name", 4},
        {"TwoElementsOfOneName", ".ply", twoVertices + "element vertex 2\n",
         "a second element 'vertex'", 7},
        {"TwoPropertiesOfOneName", ".ply", twoVertices + "property int x\n",
         "a second property 'x' of element 'vertex'", 7},
        {"UnknownKeyword", ".ply", ascii + "elements vertex 2\n",
         "unknown keyword 'elements' in the header", 3},
        {"ManyProperties", ".ply", manyProperties(), "more than 1000 properties", 1004},
        {"Faces", ".ply",
         twoVertices + "element face 7\nproperty list uchar int vertex_indices\n" + twoRows,
         "a mesh with 7 faces; a groom has strands"},
        {"PointCloud", ".ply", twoVertices + twoRows,
         "neither an element 'strand' nor an element 'edge'"},
        {"NoVertices", ".ply", ascii + strand + "end_header\n0\n", "no element 'vertex'"},
        {"NoZ", ".ply",
         ascii + "element vertex 1\nproperty float x\nproperty float y\nend_header\n0 0\n",
         "no properties x, y and z"},
        {"NoSegments", ".ply",
         twoVertices + "element strand 1\nproperty int count\n" + twoRows + "1\n",
         "no property nsegs"},
        {"NoSecondVertex", ".ply",
         twoVertices + "element edge 1\nproperty int vertex1\n" + twoRows + "0\n",
         "no properties vertex1 and vertex2"},
        {"ListInVertex", ".ply",
         twoVertices + "property list int int a\n" + strand + "end_header\n0 0 0 0\n0 1 0 0\n1\n",
         "a list among the properties of the element 'vertex'"},
        {"RedWithoutGreen", ".ply",
         twoVertices + "property uchar red\n" + strand + "end_header\n0 0 0 0\n0 1 0 0\n1\n",
         "only some of the properties red, green and blue"},
        {"DiameterTwice", ".ply",
         twoVertices + "property float diameter\nproperty float thickness\n" + strand +
             "end_header\n0 0 0 1 1\n0 1 0 1 1\n1\n",
         "both a diameter and a thickness"},
        {"TwoBillionTextVertices", ".ply",
         ascii + "element vertex 2000000000\n" + vertex + strand + twoRows,
         "cut short: the header announces 2000000000 rows of element 'vertex'"},
        {"FourBillionVertices", ".ply",
         "ply\nformat binary_little_endian 1.0\nelement vertex 4294967295\n" + vertex + strand +
             "end_header\n",
         "the header announces 4294967295 vertices; at most 2147483647"},
        {"FourBillionStrands", ".ply",
         ascii + "element vertex 0\n" + vertex +
             "element strand 4294967295\nproperty uchar nsegs\nend_header\n",
         "announces 4294967295 rows of element 'strand', more than the file has room for"},
        {"FourBillionEdges", ".ply",
         "ply\nformat binary_big_endian 1.0\nelement vertex 0\n" + vertex +
             "element edge 4294967295\n" + edges + "end_header\n",
         "announces 4294967295 rows of element 'edge', more than the file has room for"},
    };
}

std::vector<Malformed> plyBodies() {
    const std::string binary = "ply\nformat binary_little_endian 1.0\nelement vertex 2\n" + vertex;
    const auto withEdges = [](const std::string& count, const std::string& rows) {
        return ascii + "element vertex 3\n" + vertex + "element edge " + count + "\n" + edges +
               "end_header\n0 0 0\n0 1 0\n0 2 0\n" + rows;
    };
    return {
        {"NotANumber", ".ply", twoVertices + strand + "end_header\n0 0 0\n0 one 0\n1\n",
         "vertex 1 (counted from 0) of 2: found 'one' where property 'y' needs a number", 11},
        {"NanText", ".ply", twoVertices + strand + "end_header\n0 0 0\n0 nan 0\n1\n",
         "vertex 1 (counted from 0) of 2: has a position that is not finite", 11},
        {"OverflowingText", ".ply", twoVertices + strand + "end_header\n0 0 1e999\n0 1 0\n1\n",
         "vertex 0 (counted from 0) of 2: has a position that is not finite", 10},
        {"RowTooShort", ".ply", twoVertices + strand + "end_header\n0 0\n0 1 0\n1\n",
         "the row ends before its property 'z'", 10},
        {"RowTooLong", ".ply", twoVertices + strand + "end_header\n0 0 0 5\n0 1 0\n1\n",
         "found '5' after the last property of the row", 10},
        {"RowsMissing", ".ply",
         twoVertices + "element strand 2\nproperty uint nsegs\n" + twoRows + "0000\n",
         "strand 1 (counted from 0) of 2: the file ends before the end of the row", 12},
        {"TextAfterTheEnd", ".ply", twoVertices + strand + twoRows + "1\n1\n",
         "something follows the last row", 13},
        {"ColorOutOfType", ".ply",
         twoVertices + "property uchar red\nproperty uchar green\nproperty uchar blue\n" + strand +
             "end_header\n0 0 0 0 256 0\n0 1 0 0 0 0\n1\n",
         "found '256' where property 'green' needs a whole number", 13},
        {"NegativeSegments", ".ply",
         twoVertices + "element strand 1\nproperty int nsegs\n" + twoRows + "-1\n",
         "strand 0 (counted from 0) of 1: its nsegs is not a whole number of 0 or more", 12},
        {"FractionalSegments", ".ply",
         twoVertices + "element strand 1\nproperty float nsegs\n" + twoRows + "1.5\n",
         "its nsegs is not a whole number", 12},
        {"TooManySegments", ".ply",
         twoVertices + "element strand 2\nproperty uint nsegs\n" + twoRows + "4294967295\n1\n",
         "its nsegs asks for too many vertices", 12},
        {"SegmentsDisagree", ".ply", twoVertices + strand + twoRows + "2\n",
         "the nsegs of its strands ask for 3 vertices, but it has 2"},
        {"EdgeOutOfRange", ".ply", withEdges("1", "1 3\n"),
         "edge 0 (counted from 0) of 1: its vertex2 is not the index of one of the 3 vertices", 14},
        {"NegativeEdge", ".ply", withEdges("1", "-1 2\n"), "its vertex1 is not the index", 14},
        {"BranchingEdges", ".ply", withEdges("2", "0 1\n0 2\n"), "two edges leave vertex 0"},
        {"MeetingEdges", ".ply", withEdges("2", "0 1\n2 1\n"), "two edges enter vertex 1"},
        {"ClosedLoop", ".ply", withEdges("3", "0 1\n1 2\n2 0\n"), "the edges form a closed loop"},
        {"EdgeOntoItself", ".ply", withEdges("1", "1 1\n"), "the edges form a closed loop"},
        {"EdgesAcrossStrands", ".ply",
         twoVertices + "element strand 2\nproperty ushort nsegs\nelement edge 1\n" + edges +
             twoRows + "0\n0\n0 1\n",
         "edges that do not follow its strands"},
        {"BinaryCutShort", ".ply",
         Bytes().text(binary + strand + "end_header\n").f32({0, 0, 0, 0, 1}),
         "announces 2 rows of element 'vertex', more than the file has room for"},
        {"BinaryListCutShort", ".ply",
         Bytes()
             .text("ply\nformat binary_little_endian 1.0\nelement a 1\nproperty list uint double "
                   "b\nend_header\n")
             .u32({0xffffffff})
             .zeros(64),
         "a 0 (counted from 0) of 1: the file ends before the end of the row"},
        {"BinaryNan", ".ply",
         Bytes().text(binary + strand + "end_header\n").f32({0, 0, 0, nan, 1, 0}).u16({1}),
         "vertex 1 (counted from 0) of 2: has a position that is not finite"},
        {"BinaryNegativeDiameter", ".ply",
         Bytes()
             .text(binary + "property float diameter\n" + strand + "end_header\n")
             .f32({0, 0, 0, 1, 0, 1, 0, -1})
             .u16({1}),
         "vertex 1 (counted from 0) of 2: has a diameter that is not finite or below 0"},
        {"BinaryBytesAfterTheEnd", ".ply",
         Bytes().text(binary + strand + "end_header\n").f32({0, 0, 0, 0, 1, 0}).u16({1, 1}),
         "something follows the last row"},
    };
}

std::vector<Malformed> objFiles() {
    const std::string two = "v 0 0 0\nv 0 1 0\n";
    return {
        {"Empty", ".obj", "", "the file is empty"},
        {"NoLines", ".obj", two, "no polyline (l) among 2 vertices (v)", 2},
        {"Comment", ".obj", "# nothing\n", "no polyline (l) among 0 vertices (v)", 1},
        {"Binary", ".obj", hairStart, "unknown keyword 'HAIR", 1},
        {"Faces", ".obj", two + "v 1 0 0\nf 1 2 3\n", "a face; a groom has polylines (l) only", 4},
        {"Curve", ".obj", two + "cstype bspline\n", "a free-form curve or surface (cstype)", 3},
        {"UnknownKeyword", ".obj", two + "line 1 2\n", "unknown keyword 'line'", 3},
        {"VertexTooShort", ".obj", "v 0 0\n", "expected v and three numbers, found ''", 1},
        {"VertexNotANumber", ".obj", "v 0 0 0\nv 0 1,5 0\n",
         "expected v and three numbers, found '1,5'", 2},
        {"VertexNan", ".obj", "v 0 nan 0\n", "a position that is not finite", 1},
        {"VertexOverflow", ".obj", "v 0 0 1e400\n", "a position that is not finite", 1},
        {"VertexTrailingText", ".obj", "v 0 0 0 red\n", "expected numbers only, found 'red'", 1},
        {"LineOfNothing", ".obj", two + "l\n",
         "expected l and the indices of vertices, found nothing", 3},
        {"PointOfNothing", ".obj", two + "p \n",
         "expected p and the indices of vertices, found nothing", 3},
        {"IndexZero", ".obj", two + "l 0 1\n", "vertex '0' does not exist; 2 are defined so far",
         3},
        {"IndexOutOfRange", ".obj", two + "\nl 1 3\n",
         "vertex '3' does not exist; 2 are defined so far", 4},
        {"IndexBeforeVertex", ".obj", "v 0 0 0\nl 1 2\nv 0 1 0\n",
         "vertex '2' does not exist; 1 are defined so far", 2},
        {"NegativeIndexOutOfRange", ".obj", two + "l -1 -3\n", "vertex '-3' does not exist", 3},
        {"IndexNotANumber", ".obj", two + "l 1 two\n",
         "expected the index of a vertex, found 'two'", 3},
        {"IndexWithBadTexture", ".obj", two + "l 1/ 2\n",
         "expected the index of a vertex, found '1/'", 3},
        {"IndexFractional", ".obj", two + "l 1 2.0\n",
         "expected the index of a vertex, found '2.0'", 3},
        {"IndexHuge", ".obj", two + "l 1 99999999999999999999\n",
         "expected the index of a vertex, found '9999", 3},
        {"CutShortInTheLines", ".obj", two + "v 0 2 0\nv 0 3 0\nl 1 2\n",
         "vertex 3 of 4 is on no polyline (l); the file is cut short", 5},
    };
}

std::vector<Malformed> all() {
    std::vector<Malformed> files;
    for (const auto& some : {hairFiles(), plyHeaders(), plyBodies(), objFiles()}) {
        files.insert(files.end(), some.begin(), some.end());
    }
    return files;
}

class MalformedFile : public testing::TestWithParam<Malformed> {};

TEST_P(MalformedFile, IsRefusedByName) {
    const Malformed& file = GetParam();
    const test::TempFolder folder;
    const std::string path = folder.path(file.name + file.extension);
    test::writeBytes(path, file.bytes);
    const Result<Strands> strands = readGroom(path);

    ASSERT_FALSE(strands.ok());
    const Problem& problem = strands.problems().front();
    EXPECT_THAT(problem.message, HasSubstr(file.message));
    EXPECT_EQ(problem.file, path);
    EXPECT_EQ(problem.line, file.line);
    EXPECT_FALSE(problem.system);
    EXPECT_FALSE(problem.message.ends_with('.'));
}

std::string nameOf(const testing::TestParamInfo<Malformed>& test) {
    return test.param.extension.substr(1) + "_" + test.param.name;
}

INSTANTIATE_TEST_SUITE_P(Groom, MalformedFile, testing::ValuesIn(all()), nameOf);

}  // namespace
}  // namespace kushi
