// SPDX-License-Identifier: Apache-2.0
#include "io/temp_folder.h"
#include "io/test_bytes.h"

#include <kushi/image.h>
#include <kushi/layered_image.h>

#include <cmath>
#include <filesystem>
#include <limits>

#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <png.h>

namespace kushi {
namespace {

using testing::ElementsAre;
using testing::HasSubstr;

struct Decoded {
    unsigned width = 0, height = 0, format = 0;
    std::vector<int> bytes;
};

Decoded decode(const std::string& path) {
    png_image image{};
    image.version = PNG_IMAGE_VERSION;
    EXPECT_NE(png_image_begin_read_from_file(&image, path.c_str()), 0) << image.message;
    Decoded decoded{image.width, image.height, image.format, {}};
    std::vector<png_byte> bytes(PNG_IMAGE_SIZE(image));
    EXPECT_NE(png_image_finish_read(&image, nullptr, bytes.data(), 0, nullptr), 0) << image.message;
    decoded.bytes.assign(bytes.begin(), bytes.end());
    return decoded;
}

TEST(Png, PixelsStandInTheirPlaces) {
    const test::TempFolder folder;
    const std::string path = folder.path("places.png");
    Image image{3, 2, std::vector<Rgb>(6)};
    image.at(0, 0) = {1, 0, 0};
    image.at(2, 0) = {0, 1, 0};
    image.at(1, 1) = {0, 0, 1};
    ASSERT_TRUE(writePng(image, path).ok());

    const Decoded decoded = decode(path);
    EXPECT_EQ(decoded.width, 3U);
    EXPECT_EQ(decoded.height, 2U);
    EXPECT_EQ(decoded.format, unsigned{PNG_FORMAT_RGB});
    EXPECT_THAT(decoded.bytes,
                ElementsAre(255, 0, 0, 0, 0, 0, 0, 255, 0, 0, 0, 0, 0, 0, 255, 0, 0, 0));
}

/// IEC 61966-2-1, straight from its formula.
int srgb(double linear) {
    const double encoded =
        linear <= 0.0031308 ? 12.92 * linear : 1.055 * std::pow(linear, 1 / 2.4) - 0.055;
    return static_cast<int>(std::floor(encoded * 255 + 0.5));
}

TEST(Png, LinearLightBecomesSrgb) {
    const test::TempFolder folder;
    const std::string path = folder.path("ramp.png");
    constexpr int width = 10000;
    Image image{width, 1, {}};
    for (int x = 0; x < width; ++x) {
        const float t = static_cast<float>(x) / width;
        image.pixels.push_back({t, t * t, t * t * t});
    }
    ASSERT_TRUE(writePng(image, path).ok());
    const Decoded decoded = decode(path);
    for (std::size_t x = 0; x < width; ++x) {
        ASSERT_EQ(decoded.bytes[3 * x], srgb(image.pixels[x].r)) << "at " << x;
        ASSERT_EQ(decoded.bytes[3 * x + 1], srgb(image.pixels[x].g)) << "at " << x;
        ASSERT_EQ(decoded.bytes[3 * x + 2], srgb(image.pixels[x].b)) << "at " << x;
    }
}

TEST(Png, ValuesOutOfRangeAreClamped) {
    const test::TempFolder folder;
    const std::string path = folder.path("clamped.png");
    constexpr float inf = std::numeric_limits<float>::infinity();
    const Image image{2, 1, {{-1, 2, std::nanf("")}, {-inf, inf, 1e30F}}};
    ASSERT_TRUE(writePng(image, path).ok());
    EXPECT_THAT(decode(path).bytes, ElementsAre(0, 255, 0, 0, 255, 255));
}

TEST(Png, SaysThatItIsSrgbAndNotWhen) {
    const test::TempFolder folder;
    const std::string path = folder.path("chunks.png");
    const Image image{1, 1, {{0, 0, 0}}};
    ASSERT_TRUE(writePng(image, path).ok());
    const std::string bytes = test::readBytes(path);
    EXPECT_THAT(bytes, HasSubstr("sRGB"));
    EXPECT_EQ(bytes.find("tIME"), std::string::npos);
}

TEST(Png, AnImpossibleSizeIsRefused) {
    const test::TempFolder folder;
    const std::string path = folder.path("impossible.png");
    for (const Image& image :
         {Image{}, Image{0, 1, {}}, Image{-1, -1, {{}}}, Image{2, 2, std::vector<Rgb>(3)},
          Image{1000001, 1, std::vector<Rgb>(1000001)}}) {
        const Status written = writePng(image, path);
        ASSERT_FALSE(written.ok());
        EXPECT_THAT(written.problems().front().message, HasSubstr("cannot be written as PNG"));
        EXPECT_FALSE(written.problems().front().system);
        EXPECT_FALSE(std::filesystem::exists(path));
    }
}

TEST(Png, AFullDiskIsTheMachinesProblem) {
    const Image image{1, 1, {{0, 0, 0}}};
    const Status written = writePng(image, "/dev/full");
    ASSERT_FALSE(written.ok());
    EXPECT_TRUE(written.problems().front().system);
    EXPECT_EQ(written.problems().front().message, "cannot write: No space left on device");
}

TEST(Png, AlphaIsNotMultipliedIn) {
    const test::TempFolder folder;
    const std::string path = folder.path("alpha.png");
    LayeredImage image;
    image.image = {3, 1, {{0.5F, 0.25F, 0}, {0, 0, 0}, {0.2F, 0.4F, 1}}};
    image.alpha = {0.5F, 0, 1};
    ASSERT_TRUE(writePng(image, path).ok());
    const Decoded decoded = decode(path);
    EXPECT_EQ(decoded.format, unsigned{PNG_FORMAT_RGBA});
    EXPECT_THAT(decoded.bytes,
                ElementsAre(255, srgb(0.5), 0, 128, 0, 0, 0, 0, srgb(0.2), srgb(0.4), 255, 255));
    image.alpha.pop_back();
    EXPECT_FALSE(writePng(image, path).ok());
}

}  // namespace
}  // namespace kushi
