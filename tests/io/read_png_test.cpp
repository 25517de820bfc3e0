// SPDX-License-Identifier: Apache-2.0
#include "io/temp_folder.h"
#include "io/test_bytes.h"

#include <kushi/image.h>

#include <string_view>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

namespace kushi {
namespace {

using testing::ElementsAre;
using testing::HasSubstr;

// Pictures of a pixel or a few, spelled out; signature and end are always the same.
std::string png(std::string_view hex) {
    const std::string whole = "89504e470d0a1a0a" + std::string(hex) + "0000000049454e44ae426082";
    std::string bytes;
    for (std::size_t i = 0; i < whole.size(); i += 2)
        bytes += static_cast<char>(std::stoi(whole.substr(i, 2), nullptr, 16));
    return bytes;
}

const std::string grey16 =
    "0000000d494844520000000200000001100000000081d9fc150000000d4944415478da631032f9ff1f0003e60245"
    "f11c8465";
const std::string grey1 =
    "0000000d4948445200000003000000010100000000339b29190000000a4944415478da6358000000a200a17105cb"
    "41";
const std::string palette =
    "0000000d4948445200000002000000010803000000c3fc8fb800000006504c5445000000ffffffa5d99fdd000000"
    "0274524e53ff335a67515c0000000b4944415478da63606400000005000242c2449f";
const std::string colour =
    "0000000d494844520000000200000002080600000072b60d24000000134944415478da63f8cfc0f01f0c813408a4"
    "0100492f095e26928064";
const std::string interlaced =
    "0000000d494844520000000200000002080000000120da626e0000000f4944415478da63e062106190d3000000f7"
    "0065262e0e42";
const std::string huge =
    "0000000d49484452000027100000271008000000009f253dfb00000001494441547876e684e6";

Result<GreyImage> readBytes(const std::string& bytes) {
    const test::TempFolder folder;
    test::writeBytes(folder.path("a.png"), bytes);
    return readGreyPng(folder.path("a.png"));
}

std::vector<std::uint16_t> pixels(const std::string& hex) {
    const Result<GreyImage> image = readBytes(png(hex));
    EXPECT_TRUE(image.ok()) << toString(image.problems()[0]);
    return image ? image->pixels : std::vector<std::uint16_t>{};
}

TEST(ReadGreyPng, KeepsSixteenBits) {
    EXPECT_THAT(pixels(grey16), ElementsAre(0x1234, 0xFFFF));
}

TEST(ReadGreyPng, SpreadsOneBit) {
    EXPECT_THAT(pixels(grey1), ElementsAre(65535, 0, 65535));
}

// White at a fifth of its opacity, then black.
TEST(ReadGreyPng, TakesWhatIsTransparentForDarker) {
    EXPECT_THAT(pixels(palette), ElementsAre(13107, 0));
}

// Red, green and blue weigh as in ITU-R BT.709, to a step of 8 bits.
TEST(ReadGreyPng, TakesTheLuminanceOfColours) {
    const Result<GreyImage> image = readBytes(png(colour));
    ASSERT_TRUE(image.ok());
    EXPECT_EQ(image->width, 2);
    EXPECT_EQ(image->height, 2);
    EXPECT_NEAR(image->pixels[0], 0.2126 * 65535, 257);
    EXPECT_NEAR(image->pixels[1], 0.7152 * 65535, 257);
    EXPECT_NEAR(image->pixels[2], 0.0722 * 65535, 257);
    EXPECT_EQ(image->pixels[3], 26214);
}

TEST(ReadGreyPng, PutsInterlacedPixelsInTheirPlaces) {
    EXPECT_THAT(pixels(interlaced), ElementsAre(10 * 257, 20 * 257, 30 * 257, 40 * 257));
}

TEST(ReadGreyPng, RefusesWhatIsNoPictureOrDamaged) {
    EXPECT_THAT(readBytes("P5 1 1 255 0").problems()[0].message, HasSubstr("not a PNG"));
    EXPECT_THAT(readBytes("").problems()[0].message, HasSubstr("not a PNG"));
    EXPECT_THAT(readBytes(png(huge)).problems()[0].message,
                HasSubstr("10000 x 10000 pixels, expected 8192 x 8192 at most"));
    const std::string whole = png(colour);
    for (std::size_t size = 0; size + 12 < whole.size(); ++size)
        EXPECT_FALSE(readBytes(whole.substr(0, size)).ok()) << size;
    std::string damaged = whole;
    damaged[45] ^= 1;
    EXPECT_THAT(readBytes(damaged).problems()[0].message, HasSubstr("damaged"));
    const Result<GreyImage> missing = readGreyPng("no/such.png");
    ASSERT_FALSE(missing.ok());
    EXPECT_EQ(missing.problems()[0].file, "no/such.png");
}

}  // namespace
}  // namespace kushi
