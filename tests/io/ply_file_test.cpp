// SPDX-License-Identifier: Apache-2.0
#include "io/ply_file.h"

#include "io/test_bytes.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

namespace kushi {
namespace {

using test::Bytes;
using testing::ElementsAre;
using testing::FloatEq;
using testing::HasSubstr;

Strands parsed(const std::string& bytes) {
    const Result<Strands> strands = parsePly(bytes, "a.ply");
    EXPECT_TRUE(strands.ok()) << toString(strands.problems().front());
    return strands ? *strands : Strands{};
}

std::string formatted(const Strands& strands) {
    const Result<std::string> bytes = formatPly(strands, "a.ply");
    EXPECT_TRUE(bytes.ok()) << toString(bytes.problems().front());
    return bytes ? *bytes : std::string();
}

std::vector<float> xs(const Strands& strands) {
    std::vector<float> values;
    for (const Vec3f node : strands.nodes)
        values.push_back(node.x * 100);
    return values;
}

const std::string fiveVertices =
    "element vertex 5\n"
    "property float x\n"
    "property float y\n"
    "property float z\n";

TEST(PlyFile, TextWithStrandsIsRead) {
    const Strands strands =
        parsed("ply\r\nformat ascii 1.0\r\ncomment two strands\r\nobj_info x\r\n" + fiveVertices +
               "property uchar red\nproperty uchar green\nproperty uchar blue\n"
               "element strand 2\nproperty ushort nsegs\nend_header\n"
               "1 2 3 255 0 51\n"
               "2 0 0 0 0 0\n"
               "\n"
               " 3e0\t+0 -0 0 0 0 \r\n"
               "4 0 0 0 0 0\n"
               "5 0 0 0 0 0\n"
               "2\n"
               "1");
    EXPECT_THAT(strands.offsets, ElementsAre(0, 3, 5));
    EXPECT_THAT(xs(strands),
                ElementsAre(FloatEq(1), FloatEq(2), FloatEq(3), FloatEq(4), FloatEq(5)));
    EXPECT_EQ(strands.nodes[0], (Vec3f{0.01F, 0.02F, 0.03F}));
    EXPECT_EQ(strands.colors[0], (Rgb{1, 0, 0.2F}));
    EXPECT_TRUE(strands.diameters.empty());
}

/// Every type of number once, in either byte order; two strands of two nodes.
std::string binaryFile(bool bigEndian) {
    return Bytes(bigEndian)
        .text(std::string("ply\nformat binary_") + (bigEndian ? "big" : "little") +
              "_endian 1.0\n"
              "element strand 2\nproperty uint nsegs\n"
              "element weights 2\nproperty list uchar short weight\nproperty char other\n"
              "element vertex 4\nproperty double x\nproperty short y\nproperty int z\n"
              "property ushort red\nproperty ushort green\nproperty ushort blue\n"
              "property float thickness\nproperty float transparency\nproperty uint8 ignored\n"
              "element edge 2\nproperty uint vertex1\nproperty int32 vertex2\nend_header\n")
        .u32({1, 1})
        .u8({2})
        .u16({7, 7})
        .u8({1})
        .u8({0})
        .u8({1})
        .f64({0.5})
        .u16({258})
        .u32({66051})
        .u16({65535, 0, 0})
        .f32({0.01, 0.5})
        .u8({9})
        .f64({-1.5})
        .u16({65535})
        .u32({-2})
        .u16({0, 0, 0})
        .f32({0.01, 0})
        .u8({9})
        .f64({2.5})
        .u16({0})
        .u32({0})
        .u16({0, 0, 0})
        .f32({0.01, 0})
        .u8({9})
        .f64({3.5})
        .u16({0})
        .u32({0})
        .u16({0, 0, 0})
        .f32({0.01, 0})
        .u8({9})
        .u32({0, 1, 3, 2});
}

TEST(PlyFile, BinaryOfEitherByteOrderIsRead) {
    for (const bool bigEndian : {false, true}) {
        SCOPED_TRACE(bigEndian ? "big endian" : "little endian");
        const Strands strands = parsed(binaryFile(bigEndian));
        EXPECT_THAT(strands.offsets, ElementsAre(0, 2, 4));
        ASSERT_EQ(strands.nodes.size(), 4U);
        EXPECT_EQ(strands.nodes[0], (Vec3f{0.005F, 2.58F, 660.51F}));
        EXPECT_EQ(strands.nodes[1], (Vec3f{-0.015F, -0.01F, -0.02F}));
        EXPECT_EQ(strands.colors[0], (Rgb{1, 0, 0}));
        EXPECT_FLOAT_EQ(strands.diameters[3], 1e-4F);
        EXPECT_EQ(strands.transparency[0], 0.5F);
    }
}

TEST(PlyFile, EdgesAloneAreFollowedFromRootToTip) {
    const Strands strands = parsed("ply\nformat ascii 1.0\n" + fiveVertices +
                                   "element edge 3\nproperty int vertex1\nproperty int vertex2\n"
                                   "end_header\n10 0 0\n11 0 0\n12 0 0\n13 0 0\n14 0 0\n"
                                   "3 1\n1 0\n4 2\n");
    // Roots are the vertices that no edge enters: 3 and 4.
    EXPECT_THAT(strands.offsets, ElementsAre(0, 3, 5));
    EXPECT_THAT(xs(strands),
                ElementsAre(FloatEq(13), FloatEq(11), FloatEq(10), FloatEq(14), FloatEq(12)));
}

TEST(PlyFile, AVertexWithoutEdgesIsAStrandOfOneNode) {
    const Strands strands = parsed("ply\nformat ascii 1.0\n" + fiveVertices +
                                   "element edge 2\nproperty int vertex1\nproperty int vertex2\n"
                                   "end_header\n10 0 0\n11 0 0\n12 0 0\n13 0 0\n14 0 0\n"
                                   "0 1\n3 4\n");
    EXPECT_THAT(strands.offsets, ElementsAre(0, 2, 3, 5));
}

TEST(PlyFile, NoStrandsAtAllAreReadAndWritten) {
    EXPECT_EQ(parsed(formatted(Strands{})).size(), 0U);
}

Strands twoStrands() {
    Strands strands;
    strands.add(std::vector<Vec3f>{{1, 0, 0}, {2, 0, 0}}, 1);
    strands.add(std::vector<Vec3f>{{3, 4, 5}}, 2);
    strands.diameters = {0.01F, 0.02F, 0.03F};
    strands.transparency = {0, 0.5F, 1};
    strands.colors = {{1, 2, 3}, {4, 5, 6}, {7, 8, 9}};
    return strands;
}

TEST(PlyFile, StrandsAreWrittenWithAllAttributesAndEdgesForMeshViewers) {
    const std::string expected =
        Bytes()
            .text(
                "ply\nformat binary_little_endian 1.0\ncomment Kushi, centimetres, y up\n"
                "element vertex 3\nproperty float x\nproperty float y\nproperty float z\n"
                "property float red\nproperty float green\nproperty float blue\n"
                "property float diameter\nproperty float transparency\n"
                "element strand 2\nproperty ushort nsegs\n"
                "element edge 1\nproperty int vertex1\nproperty int vertex2\nend_header\n")
            .f32({100, 0, 0, 1, 2, 3, 1, 0})
            .f32({200, 0, 0, 4, 5, 6, 2, 0.5})
            .f32({300, 400, 500, 7, 8, 9, 3, 1})
            .u16({1, 0})
            .u32({0, 1});
    EXPECT_EQ(formatted(twoStrands()), expected);
}

TEST(PlyFile, WhatIsWrittenIsRead) {
    const Strands strands = twoStrands();
    const Strands back = parsed(formatted(strands));
    EXPECT_EQ(back.offsets, strands.offsets);
    EXPECT_EQ(back.nodes, strands.nodes);
    EXPECT_EQ(back.diameters, strands.diameters);
    EXPECT_EQ(back.transparency, strands.transparency);
    EXPECT_EQ(back.colors, strands.colors);
    EXPECT_TRUE(back.keys.empty());
}

TEST(PlyFile, AStrandOfMoreThan65536NodesIsWrittenAndRead) {
    Strands strands;
    strands.add(std::vector<Vec3f>(70000, Vec3f{1, 2, 3}), 1);
    const std::string bytes = formatted(strands);
    EXPECT_THAT(bytes.substr(0, 400), HasSubstr("property uint nsegs\n"));
    EXPECT_THAT(parsed(bytes).offsets, ElementsAre(0, 70000));
}

}  // namespace
}  // namespace kushi
