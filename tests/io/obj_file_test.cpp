// SPDX-License-Identifier: Apache-2.0
#include "io/obj_file.h"

#include <cmath>
#include <random>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

namespace kushi {
namespace {

using testing::ElementsAre;
using testing::HasSubstr;

Strands parsed(const std::string& text) {
    const Result<Strands> strands = parseObj(text, "a.obj");
    EXPECT_TRUE(strands.ok()) << toString(strands.problems().front());
    return strands ? *strands : Strands{};
}

std::string formatted(const Strands& strands) {
    const Result<std::string> text = formatObj(strands, "a.obj");
    EXPECT_TRUE(text.ok()) << toString(text.problems().front());
    return text ? *text : std::string();
}

/// The x of every node in cm, rounded: in these files its vertex.
std::vector<long> vertices(const Strands& strands) {
    std::vector<long> numbers;
    for (const Vec3f node : strands.nodes)
        numbers.push_back(std::lround(node.x * 100));
    return numbers;
}

const std::string fourVertices = "v 1 0 0\nv 2 0 0\nv 3 0 0\nv 4 0 0\n";

TEST(ObjFile, APolylineIsAStrand) {
    const Strands strands =
        parsed("v 1 -2.5e1 +3\nv 2 0 0\nv 3 0 0\nv 4 0 0\nv 5 0 0\nl 1 2 3\nl 5 4\n");
    EXPECT_THAT(strands.offsets, ElementsAre(0, 3, 5));
    EXPECT_THAT(vertices(strands), ElementsAre(1, 2, 3, 5, 4));
    EXPECT_EQ(strands.nodes[0], (Vec3f{0.01F, -0.25F, 0.03F}));
}

TEST(ObjFile, ConsecutiveLinesOfTwoThatChainMakeOneStrand) {
    const Strands strands = parsed(
        "v 1 0 0\nv 2 0 0\nv 3 0 0\nv 4 0 0\nv 5 0 0\nv 6 0 0\nv 7 0 0\n"
        "l 1 2\nl 2 3\nl 3 4\nl 5 6\nl 6 7\n");
    EXPECT_THAT(strands.offsets, ElementsAre(0, 4, 7));
    EXPECT_THAT(vertices(strands), ElementsAre(1, 2, 3, 4, 5, 6, 7));
}

TEST(ObjFile, LinesChainAcrossTheirVerticesAndCommentsButNotAcrossObjects) {
    EXPECT_THAT(parsed("v 1 0 0\nv 2 0 0\nl 1 2\nv 3 0 0\n# more\nl 2 3\n").offsets,
                ElementsAre(0, 3));
    EXPECT_THAT(parsed("v 1 0 0\nv 2 0 0\nv 3 0 0\nl 1 2\no next\nl 2 3\n").offsets,
                ElementsAre(0, 2, 4));
}

TEST(ObjFile, LinesThatDoNotChainAreStrandsOfTheirOwn) {
    EXPECT_THAT(parsed(fourVertices + "l 1 2\nl 3 2\nl 2 4\n").offsets, ElementsAre(0, 2, 5));
    EXPECT_THAT(parsed(fourVertices + "l 1 2\nl 2 3 4\n").offsets, ElementsAre(0, 2, 5));
    EXPECT_THAT(parsed(fourVertices + "l 1 2 3\nl 3 4\n").offsets, ElementsAre(0, 3, 5));
}

TEST(ObjFile, NegativeIndicesCountBackFromTheLatestVertex) {
    const Strands strands = parsed("v 1 0 0\nv 2 0 0\nl -2 -1\nv 3 0 0\nv 4 0 0\nl -1 -2\n");
    EXPECT_THAT(strands.offsets, ElementsAre(0, 2, 4));
    EXPECT_THAT(vertices(strands), ElementsAre(1, 2, 4, 3));
}

TEST(ObjFile, TextureIndicesArePassedOver) {
    EXPECT_THAT(vertices(parsed(fourVertices + "vt 0 0\nl 1/1 2/1 3/-1 4\n")),
                ElementsAre(1, 2, 3, 4));
}

TEST(ObjFile, AStrandOfOneNodeIsAPointOrALineOfOne) {
    const Strands strands = parsed(fourVertices + "p 1 2\nl 3\np 4\n");
    EXPECT_THAT(strands.offsets, ElementsAre(0, 1, 2, 3, 4));
}

TEST(ObjFile, WhatAGroomCanDoWithoutIsPassedOver) {
    const Strands strands = parsed(
        "\n# hair\nmtllib a.mtl\r\no hair#1\ng a b\ns off\nvn 0 0 1\n"
        "v 1 0 0 1.0\nv 2 0 0 0.5 0.5 0.5 # brown\n\tl  1\t2  \r\nusemtl m\n");
    EXPECT_THAT(vertices(strands), ElementsAre(1, 2));
}

TEST(ObjFile, ABackslashContinuesALine) {
    EXPECT_THAT(vertices(parsed(fourVertices + "l 1 2 \\\n3\\\r\n 4\n")), ElementsAre(1, 2, 3, 4));
}

TEST(ObjFile, ACommentIsNotContinued) {
    EXPECT_THAT(vertices(parsed("# C:\\\nv 1 0 0\nv 2 0 0\nl 1 2\n")), ElementsAre(1, 2));
}

TEST(ObjFile, TheLastLineMayLackItsEnd) {
    EXPECT_THAT(vertices(parsed("v 1 0 0\nv 2 0 0\nl 1 2")), ElementsAre(1, 2));
}

TEST(ObjFile, StrandsAreWrittenInCentimetresAsPolylinesAndPoints) {
    Strands strands;
    strands.add(std::vector<Vec3f>{{1, -0.5F, 0}, {0.25F, 0, 0}}, 1);
    strands.add(std::vector<Vec3f>{{2, 0, 0}}, 2);
    strands.diameters = {1, 1, 1};  // left out
    EXPECT_EQ(formatted(strands),
              "# Kushi, centimetres, y up\nv 100 -50 0\nv 25 0 0\nv 200 0 0\nl 1 2\np 3\n");
}

TEST(ObjFile, WhatIsWrittenIsReadExactly) {
    std::mt19937 random(7);
    std::uniform_real_distribution<float> exponent(-20, 12);
    Strands strands;
    for (int i = 0; i < 100; ++i) {
        std::vector<Vec3f> nodes(30);
        for (Vec3f& node : nodes) {
            node = {std::exp2(exponent(random)), -std::exp2(exponent(random)), 0};
        }
        strands.add(nodes, 1);
    }
    const Strands back = parsed(formatted(strands));
    EXPECT_EQ(back.offsets, strands.offsets);
    EXPECT_EQ(back.nodes, strands.nodes);
}

TEST(ObjFile, TwoStrandsOfTwoNodesStayTwo) {
    Strands strands;
    strands.add(std::vector<Vec3f>{{1, 0, 0}, {2, 0, 0}}, 1);
    strands.add(std::vector<Vec3f>{{2, 0, 0}, {3, 0, 0}}, 2);
    EXPECT_THAT(parsed(formatted(strands)).offsets, ElementsAre(0, 2, 4));
}

TEST(ObjFile, AGroomWithoutStrandsIsRefused) {
    const Result<std::string> text = formatObj(Strands{}, "a.obj");
    ASSERT_FALSE(text.ok());
    EXPECT_THAT(text.problems().front().message, HasSubstr("without strands"));
}

}  // namespace
}  // namespace kushi
