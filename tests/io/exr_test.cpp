// SPDX-License-Identifier: Apache-2.0
#include "io/temp_folder.h"

#include <kushi/layered_image.h>

#include <filesystem>
#include <fstream>
#include <map>

#include <ImfChannelList.h>
#include <ImfFrameBuffer.h>
#include <ImfHeader.h>
#include <ImfInputFile.h>
#include <gmock/gmock.h>

namespace kushi {
namespace {

using testing::ElementsAre;
using testing::HasSubstr;

LayeredImage picture(int width, int height) {
    LayeredImage picture;
    const auto pixels = static_cast<std::size_t>(width) * static_cast<std::size_t>(height);
    picture.image = {width, height, std::vector<Rgb>(pixels)};
    picture.alpha.assign(pixels, 0);
    return picture;
}

/// What OpenEXR reads of a file, by channel, all as the type the file has.
struct Decoded {
    int width = 0, height = 0;
    std::map<std::string, Imf::PixelType> types;
    std::map<std::string, std::vector<float>> floats;
    std::map<std::string, std::vector<std::uint32_t>> integers;
};

Decoded decode(const std::string& path) {
    Imf::InputFile file(path.c_str());
    const Imath::Box2i window = file.header().dataWindow();
    Decoded decoded;
    decoded.width = window.max.x - window.min.x + 1;
    decoded.height = window.max.y - window.min.y + 1;
    const auto width = static_cast<std::size_t>(decoded.width);
    const auto pixels = width * static_cast<std::size_t>(decoded.height);
    Imf::FrameBuffer buffer;
    const Imf::ChannelList& channels = file.header().channels();
    for (auto channel = channels.begin(); channel != channels.end(); ++channel) {
        const std::string name = channel.name();
        const Imf::PixelType type = channel.channel().type;
        decoded.types[name] = type;
        char* place = nullptr;
        if (type == Imf::UINT) {
            decoded.integers[name].resize(pixels);
            place = reinterpret_cast<char*>(decoded.integers[name].data());
        } else {
            decoded.floats[name].resize(pixels);
            place = reinterpret_cast<char*>(decoded.floats[name].data());
        }
        buffer.insert(name.c_str(),
                      Imf::Slice(type == Imf::UINT ? Imf::UINT : Imf::FLOAT, place, 4, 4 * width));
    }
    file.setFrameBuffer(buffer);
    file.readPixels(window.min.y, window.max.y);
    return decoded;
}

TEST(Exr, PixelsStandInTheirPlacesInLinearLight) {
    const test::TempFolder folder;
    const std::string path = folder.path("places.exr");
    LayeredImage written = picture(3, 2);
    written.image.at(0, 0) = {1, 0.25F, 4};
    written.image.at(2, 0) = {0, 0.5F, 0};
    written.image.at(1, 1) = {-0.5F, 0, 0.125F};
    written.alpha = {1, 0, 0.5F, 0, 0.25F, 0};
    ASSERT_TRUE(writeExr(written, path).ok());

    const Decoded read = decode(path);
    EXPECT_EQ(read.width, 3);
    EXPECT_EQ(read.height, 2);
    EXPECT_THAT(read.floats.at("R"), ElementsAre(1, 0, 0, 0, -0.5F, 0));
    EXPECT_THAT(read.floats.at("G"), ElementsAre(0.25F, 0, 0.5F, 0, 0, 0));
    EXPECT_THAT(read.floats.at("B"), ElementsAre(4, 0, 0, 0, 0.125F, 0));
    EXPECT_THAT(read.floats.at("A"), ElementsAre(1, 0, 0.5F, 0, 0.25F, 0));
    EXPECT_EQ(read.types.size(), 4U);
    EXPECT_EQ(read.types.at("R"), Imf::HALF);
}

TEST(Exr, KeepsLayersToTheLastBit) {
    const test::TempFolder folder;
    const std::string path = folder.path("layers.exr");
    LayeredImage written = picture(2, 1);
    written.depth = {0.123456789F, LayeredImage::nothing};
    written.tangent = {{0.1F, -0.7F, 1 / 3.0F}, {}};
    written.strand = {16777217, LayeredImage::noStrand};  // more than a float can hold
    written.mask = {0.3F, 0};
    ASSERT_TRUE(writeExr(written, path).ok());

    const Decoded read = decode(path);
    EXPECT_EQ(read.types.size(), 10U);
    EXPECT_EQ(read.floats.at("Z"), written.depth);
    EXPECT_THAT(read.floats.at("tangent.X"), ElementsAre(0.1F, 0));
    EXPECT_THAT(read.floats.at("tangent.Y"), ElementsAre(-0.7F, 0));
    EXPECT_THAT(read.floats.at("tangent.Z"), ElementsAre(1 / 3.0F, 0));
    EXPECT_EQ(read.integers.at("id.strand"), written.strand);
    EXPECT_EQ(read.floats.at("mask.A"), written.mask);
    EXPECT_EQ(read.types.at("Z"), Imf::FLOAT);
    EXPECT_EQ(read.types.at("id.strand"), Imf::UINT);
}

TEST(Exr, WritesTheSameBytesForTheSamePicture) {
    const test::TempFolder folder;
    LayeredImage written = picture(40, 33);
    for (std::size_t i = 0; i < written.alpha.size(); ++i)
        written.image.pixels[i] = Rgb{1, 2, 3} * static_cast<float>(i % 7);
    written.depth.assign(written.alpha.size(), 0.5F);
    const auto bytes = [&](const char* name) {
        const std::string path = folder.path(name);
        EXPECT_TRUE(writeExr(written, path).ok());
        std::ifstream file(path, std::ios::binary);
        return std::string(std::istreambuf_iterator<char>(file), {});
    };
    EXPECT_EQ(bytes("one.exr"), bytes("two.exr"));
}

TEST(Exr, RefusesLayersThatDoNotFit) {
    const test::TempFolder folder;
    const std::string path = folder.path("bad.exr");
    std::vector<LayeredImage> bad(6, picture(2, 2));
    bad[0] = {};
    bad[1].alpha.pop_back();
    bad[2].depth.assign(3, 1);
    bad[3].tangent.assign(5, {});
    bad[4].strand.assign(1, 1);
    bad[5].image.width = 3;
    for (const LayeredImage& image : bad) {
        const Status written = writeExr(image, path);
        ASSERT_FALSE(written.ok());
        EXPECT_THAT(written.problems()[0].message, HasSubstr("other sizes"));
    }
    EXPECT_FALSE(std::filesystem::exists(path));
}

TEST(Exr, SaysWhenItCannotWrite) {
    const test::TempFolder folder;
    const Status nowhere = writeExr(picture(2, 2), folder.path("none/a.exr"));
    ASSERT_FALSE(nowhere.ok());
    EXPECT_TRUE(nowhere.problems()[0].system);
    if (std::filesystem::exists("/dev/full")) {
        const Status full = writeExr(picture(2, 2), "/dev/full");
        ASSERT_FALSE(full.ok());
        EXPECT_TRUE(full.problems()[0].system);
        EXPECT_THAT(full.problems()[0].message, HasSubstr("No space"));
    }
}

}  // namespace
}  // namespace kushi
