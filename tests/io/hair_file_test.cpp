// SPDX-License-Identifier: Apache-2.0
#include "io/hair_file.h"

#include "io/test_bytes.h"

#include <cmath>
#include <random>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

namespace kushi {
namespace {

using test::Bytes;
using test::HairHeader;
using testing::ElementsAre;
using testing::FloatEq;
using testing::HasSubstr;

Strands parsed(const std::string& bytes) {
    const Result<Strands> strands = parseHair(bytes, "a.hair");
    EXPECT_TRUE(strands.ok()) << toString(strands.problems().front());
    return strands ? *strands : Strands{};
}

std::string formatted(const Strands& strands) {
    const Result<std::string> bytes = formatHair(strands, "a.hair");
    EXPECT_TRUE(bytes.ok()) << toString(bytes.problems().front());
    return bytes ? *bytes : std::string();
}

std::string refusal(const Strands& strands) {
    const Result<std::string> bytes = formatHair(strands, "a.hair");
    return bytes ? "" : bytes.problems().front().message;
}

Strands straight(std::initializer_list<int> nodeCounts) {
    Strands strands;
    for (const int count : nodeCounts) {
        std::vector<Vec3f> nodes(static_cast<std::size_t>(count));
        for (std::size_t i = 0; i < nodes.size(); ++i)
            nodes[i].y = static_cast<float>(i);
        strands.add(nodes, 1);
    }
    return strands;
}

TEST(HairFile, StrandsOfOneLengthNeedNoSegmentsArray) {
    Bytes bytes = HairHeader{2, 4, 2, 1};
    bytes.f32({1, 2, 3, 4, 5, 6, 7, 8, 9, 10, 11, 12});
    const Strands strands = parsed(bytes);
    EXPECT_THAT(strands.offsets, ElementsAre(0, 2, 4));
    EXPECT_THAT(strands.nodes, ElementsAre(Vec3f{0.01F, 0.02F, 0.03F}, Vec3f{0.04F, 0.05F, 0.06F},
                                           Vec3f{0.07F, 0.08F, 0.09F}, Vec3f{0.10F, 0.11F, 0.12F}));
}

TEST(HairFile, SegmentsArrayGivesEachStrandItsNodes) {
    Bytes bytes = HairHeader{3, 6, 3, 99};
    bytes.u16({2, 0, 1}).f32({1, 0, 0, 2, 0, 0, 3, 0, 0, 4, 0, 0, 5, 0, 0, 6, 0, 0});
    const Strands strands = parsed(bytes);
    EXPECT_THAT(strands.offsets, ElementsAre(0, 3, 4, 6));
    EXPECT_FLOAT_EQ(strands.strand(1)[0].x, 0.04F);
}

TEST(HairFile, AttributesAreReadInTheOrderOfTheFormat) {
    Bytes bytes = HairHeader{1, 2, 2 + 4 + 8 + 16, 1};
    bytes.f32({0, 0, 0, 0, 1, 0}).f32({0.01, 0.005}).f32({0, 0.5}).f32({1, 2, 3, 4, 5, 6});
    const Strands strands = parsed(bytes);
    EXPECT_THAT(strands.diameters, ElementsAre(FloatEq(1e-4F), FloatEq(5e-5F)));
    EXPECT_THAT(strands.transparency, ElementsAre(0.0F, 0.5F));
    EXPECT_THAT(strands.colors, ElementsAre(Rgb{1, 2, 3}, Rgb{4, 5, 6}));
}

TEST(HairFile, DefaultsOfTheHeaderAreNotAttributes) {
    Bytes bytes = HairHeader{1, 2, 2, 1};
    bytes.f32({0, 0, 0, 0, 1, 0});
    const Strands strands = parsed(bytes);
    EXPECT_TRUE(strands.diameters.empty());
    EXPECT_TRUE(strands.transparency.empty());
    EXPECT_TRUE(strands.colors.empty());
}

TEST(HairFile, NoStrandsAtAllAreReadAndWritten) {
    EXPECT_EQ(parsed(Bytes(HairHeader{})).size(), 0U);
    EXPECT_EQ(parsed(formatted(Strands{})).size(), 0U);
}

TEST(HairFile, EqualStrandsAreWrittenWithoutASegmentsArray) {
    const std::string bytes = formatted(straight({3, 3}));
    ASSERT_EQ(bytes.size(), 128U + 6 * 12);
    const std::string expected = Bytes().text("HAIR").u32({2, 6, 2, 2});
    EXPECT_EQ(bytes.substr(0, 20), expected);
    EXPECT_EQ(bytes.substr(128), std::string(Bytes().f32({0, 0, 0, 0, 100, 0, 0, 200, 0,  //
                                                          0, 0, 0, 0, 100, 0, 0, 200, 0})));
}

TEST(HairFile, UnequalStrandsAreWrittenWithASegmentsArray) {
    const std::string bytes = formatted(straight({2, 3}));
    ASSERT_EQ(bytes.size(), 128U + 2 * 2 + 5 * 12);
    EXPECT_EQ(bytes.substr(0, 20), std::string(Bytes().text("HAIR").u32({2, 5, 3, 0})));
    EXPECT_EQ(bytes.substr(128, 4), std::string(Bytes().u16({1, 2})));
}

TEST(HairFile, AttributesAreWrittenInTheOrderOfTheFormat) {
    Strands strands = straight({2});
    strands.diameters = {0.01F, 0.02F};
    strands.transparency = {0, 0.25F};
    strands.colors = {{1, 2, 3}, {4, 5, 6}};
    const std::string bytes = formatted(strands);
    EXPECT_EQ(bytes.substr(0, 20), std::string(Bytes().text("HAIR").u32({1, 2, 30, 1})));
    EXPECT_EQ(bytes.substr(128 + 24),
              std::string(Bytes().f32({1, 2}).f32({0, 0.25}).f32({1, 2, 3, 4, 5, 6})));
}

TEST(HairFile, WritingWhatWasReadGivesTheSameBytesFromTheSecondTimeOn) {
    std::mt19937 random(7);
    std::uniform_real_distribution<float> exponent(-12, 12);
    Strands strands;
    std::vector<Vec3f> nodes(3 * 1000);
    for (Vec3f& node : nodes) {
        node = {std::exp2(exponent(random)), -std::exp2(exponent(random)), 0};
    }
    strands.add(nodes, 1);

    const std::string once = formatted(strands);
    const Strands back = parsed(once);
    EXPECT_EQ(formatted(back), once);
    for (std::size_t i = 0; i < nodes.size(); ++i) {
        ASSERT_NEAR(back.nodes[i].x, nodes[i].x, 1e-7 * nodes[i].x);
        ASSERT_NEAR(back.nodes[i].y, nodes[i].y, -1e-7 * nodes[i].y);
    }
}

TEST(HairFile, AStrandOfOneNodeIsRefused) {
    EXPECT_THAT(refusal(straight({3, 1})),
                HasSubstr("2 to 65536 nodes, but strand 1 (counted from 0) has 1;"));
}

TEST(HairFile, AStrandOfMoreThan65536NodesIsRefused) {
    EXPECT_EQ(refusal(straight({65536})), "");
    EXPECT_THAT(refusal(straight({65537})), HasSubstr("strand 0 (counted from 0) has 65537;"));
}

TEST(HairFile, NumbersThatAreNotFiniteAreRefused) {
    Strands position = straight({2, 2});
    position.nodes[3].z = std::nanf("");
    EXPECT_THAT(refusal(position), HasSubstr("strand 1 (counted from 0) of the groom to write has "
                                             "a position that is not finite"));

    Strands tooLarge = straight({2});
    tooLarge.nodes[0].x = 1e37F;  // in centimetres more than a float holds
    EXPECT_THAT(refusal(tooLarge), HasSubstr("a position that is not finite"));

    Strands diameter = straight({2});
    diameter.diameters = {1e-4F, -1e-4F};
    EXPECT_THAT(refusal(diameter), HasSubstr("a diameter that is not finite or below 0"));

    Strands transparency = straight({2});
    transparency.transparency = {0, 1.5F};
    EXPECT_THAT(refusal(transparency), HasSubstr("a transparency that is not between 0 and 1"));

    Strands color = straight({2});
    color.colors = {{0, 0, 0}, {0, INFINITY, 0}};
    EXPECT_THAT(refusal(color), HasSubstr("a colour that is not finite"));
}

TEST(HairFile, AGroomThatContradictsItselfIsRefused) {
    Strands missing = straight({2});
    missing.diameters = {1e-4F};
    EXPECT_THAT(refusal(missing), HasSubstr("contradicts itself"));

    Strands offsets = straight({2, 2});
    offsets.offsets = {0, 3, 2, 4};
    EXPECT_THAT(refusal(offsets), HasSubstr("contradicts itself"));

    Strands bald = straight({2});
    bald.offsets = {0, 0, 2};
    EXPECT_THAT(refusal(bald),
                HasSubstr("strand 0 (counted from 0) of the groom to write has no node"));
}

}  // namespace
}  // namespace kushi
