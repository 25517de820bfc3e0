// SPDX-License-Identifier: Apache-2.0
#include "cli/program.h"

#include <kushi/image.h>

#include <algorithm>
#include <cmath>
#include <filesystem>
#include <string>
#include <vector>

#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

namespace kushi::test {
namespace {

TEST(RenderCommand, WritesAPngOfTheSizeAskedForAndTheSameBytesFromAnyThreads) {
    const std::string folder = freshFolder();
    writeText(folder + "/a.toml", smallStyle());
    const std::string command =
        "render " + folder + "/a.toml -o " + folder + "/a.png --size 200x100 --threads ";
    std::string first;
    for (const char* threads : {"1", "2", "8"}) {
        const Outcome run = runKushi(std::string(command).append(threads));
        ASSERT_EQ(run.status, 0) << run.err;
        const std::string bytes = readBytes(folder + "/a.png");
        ASSERT_EQ(bytes.substr(1, 3), "PNG");
        EXPECT_EQ(pngSize(bytes), (std::pair<std::uint32_t, std::uint32_t>(200, 100)));
        if (first.empty()) first = bytes;
        EXPECT_TRUE(bytes == first) << threads;
    }
}

// A zoomed picture is a cut of a larger one.
TEST(RenderCommand, ZoomsToAPlaceOfThePicture) {
    const std::string folder = freshFolder();
    writeText(folder + "/a.toml", smallStyle());
    const auto render = [&](const std::string& flags, const std::string& name) {
        const std::string path = folder + "/" + name + ".png";
        const Outcome run =
            runKushi("render " + folder + "/a.toml --look paper -o " + path + " " + flags);
        EXPECT_EQ(run.status, 0) << run.err;
        return *readGreyPng(path);
    };
    const GreyImage large = render("--size 800x800", "large");
    const GreyImage part = render("--size 200x200 --zoom 4,0.375,0.25", "part");
    const auto difference = [&](int left, int top) {
        double sum = 0;
        for (int y = 0; y < 200; ++y) {
            for (int x = 0; x < 200; ++x)
                sum += std::abs(large.pixels[static_cast<std::size_t>((top + y) * 800 + left + x)] -
                                part.pixels[static_cast<std::size_t>(y * 200 + x)]);
        }
        return sum / (200 * 200 * 65535.0);
    };
    EXPECT_LT(difference(200, 100), 0.5 * difference(200, 120));
    EXPECT_LT(difference(200, 100), 0.5 * difference(220, 100));
    for (const char* zoom : {"0.5", "2,0.5", "2,0.5,1.5", "2,0.5,0.5,1", "near", "2;3;4"}) {
        const Outcome run =
            runKushi("render " + folder + "/a.toml -o " + folder + "/b.png --zoom '" + zoom + "'");
        EXPECT_EQ(run.status, 2) << zoom;
        EXPECT_NE(run.err.find("--zoom is TIMES"), std::string::npos) << run.err;
    }
}

TEST(RenderCommand, DrawsAHeadFromAFileBesideTheStyle) {
    const std::string folder = freshFolder();
    const auto render = [&](const std::string& head, const std::string& name) {
        writeText(folder + "/" + name + ".toml", smallStyle(head));
        const Outcome run = runKushi("render " + folder + "/" + name + ".toml -o " + folder + "/" +
                                     name + ".png --size 64x64");
        EXPECT_EQ(run.status, 0) << run.err;
        return readBytes(folder + "/" + name + ".png");
    };
    writeText(folder + "/head.obj",
              "v 0 0 0\nv 20 0 0\nv 0 30 0\nv 0 0 20\nf 1 3 2\nf 1 2 4\n"
              "f 1 4 3\nf 2 3 4\n");
    const std::string bare = render("mesh = \"none\"", "bare");
    const std::string pointed = render("mesh = \"head.obj\"", "pointed");
    EXPECT_FALSE(bare == pointed);
    EXPECT_EQ(runKushi("check " + folder + "/pointed.toml").status, 0);
}

// Dense hair leaves less scalp to be seen than sparse hair; what is known is named by view.
TEST(RenderCommand, ReportsTheScalpThatShows) {
    const std::string folder = freshFolder();
    writeText(folder + "/a.toml", smallStyle());
    const auto showing = [&](const std::string& flags) {
        const Outcome run =
            runKushi("render " + folder + "/a.toml -o " + folder +
                     "/a.png --size 100x100 --report " + folder + "/r.json " + flags);
        EXPECT_EQ(run.status, 0) << run.err;
        return nlohmann::json::parse(readBytes(folder + "/r.json"))["scalp_showing"];
    };
    const auto sparse = showing("");
    const auto dense = showing("--count 3000");
    double most = 0;
    for (const char* view : {"front", "back", "left", "right", "top", "three-quarter"}) {
        most = std::max(most, sparse[view].get<double>());
        EXPECT_LT(dense[view], sparse[view]) << view;
    }
    EXPECT_EQ(sparse["max"], most);
    EXPECT_GT(most, 0.1);
    EXPECT_LE(most, 1);

    writeText(folder + "/a.toml", smallStyle("mesh = \"none\""));
    EXPECT_TRUE(showing("").is_null());
}

// What a collider hides is no scalp that shows, and a collider is no scalp.
TEST(RenderCommand, ReportsNoScalpUnderAHat) {
    const std::string folder = freshFolder();
    const std::filesystem::path styles = std::string(KUSHI_SOURCE_DIR) + "/styles";
    for (const char* name : {"hat.toml", "hat.obj"})
        std::filesystem::copy_file(styles / name, folder + "/" + name);
    const Outcome run = runKushi("render " + folder + "/hat.toml -o " + folder +
                                 "/a.png --size 100x100 --count 60 --report " + folder + "/r.json");
    ASSERT_EQ(run.status, 0) << run.err;
    const auto showing = nlohmann::json::parse(readBytes(folder + "/r.json"))["scalp_showing"];
    EXPECT_EQ(showing["top"], 0);
    EXPECT_GT(showing["back"], 0);  // below the hat
}

TEST(RenderCommand, TracesPaths) {
    const std::string folder = freshFolder();
    writeText(folder + "/a.toml", smallStyle());
    const auto bytes = [&](const std::string& flags) {
        const Outcome run = runKushi("render " + folder + "/a.toml -o " + folder +
                                     "/a.png --size 40x30 --engine path " + flags);
        EXPECT_EQ(run.status, 0) << run.err;
        EXPECT_NE(run.out.find("samples a pixel, noise "), std::string::npos) << run.out;
        EXPECT_NE(run.out.find("trace"), std::string::npos) << run.out;
        EXPECT_EQ(run.err, "");
        return readBytes(folder + "/a.png");
    };
    const std::string one = bytes("--spp 4 --threads 1");
    EXPECT_EQ(pngSize(one), (std::pair<std::uint32_t, std::uint32_t>(40, 30)));
    EXPECT_TRUE(one == bytes("--spp 4 --threads 3"));
    EXPECT_FALSE(one == bytes("--spp 4 --seed 1"));
    EXPECT_FALSE(one == bytes("--spp 5"));
    EXPECT_FALSE(one == bytes("--spp 4 --bounces 1"));
    EXPECT_FALSE(bytes("--spp 512 --noise 0.5") == bytes("--spp 512"));
}

TEST(RenderCommand, DrawsGroomsMadeElsewhere) {
    const std::string folder = freshFolder();
    writeText(folder + "/a.obj", "v 0 0 0\nv 1 1 0\nv 1 2 3\nl 1 2 3\n");
    const Outcome run = runKushi("render " + folder + "/a.obj -o " + folder +
                                 "/a.png --size 64x64 --view 30,10 --supersample 1");
    EXPECT_EQ(run.status, 0) << run.err;
    EXPECT_EQ(readBytes(folder + "/a.png").substr(1, 3), "PNG");
}

TEST(RenderCommand, WritesOpenExrWithTheLayersAskedFor) {
    const std::string folder = freshFolder();
    writeText(folder + "/a.toml", smallStyle());
    const auto render = [&](const std::string& flags) {
        const Outcome run =
            runKushi("render " + folder + "/a.toml -o " + folder + "/a.exr --size 64x64 " + flags);
        EXPECT_EQ(run.status, 0) << run.err;
        return readBytes(folder + "/a.exr");
    };
    const std::string plain = render("");
    EXPECT_EQ(plain.substr(0, 4), "\x76\x2f\x31\x01");  // the magic number of OpenEXR
    EXPECT_EQ(plain.find("tangent.X"), std::string::npos);
    const std::string all = render("--layers depth,tangent,id,mask --threads 1");
    for (const char* channel : {"A", "B", "G", "R", "Z", "id.strand", "mask.A", "tangent.X"})
        EXPECT_NE(all.find(std::string(1, '\0') + channel + '\0'), std::string::npos) << channel;
    EXPECT_EQ(render("--layers depth,tangent,id,mask --threads 5"), all);
    EXPECT_NE(render("--stroke analytic --layers mask").find("mask.A"), std::string::npos);
}

TEST(RenderCommand, SaysWhichLayersThereAreAndWhere) {
    const std::string folder = freshFolder();
    writeText(folder + "/a.toml", smallStyle());
    const auto refuse = [&](const std::string& flags, const std::string& why) {
        const Outcome run = runKushi("render " + folder + "/a.toml -o " + folder + flags);
        EXPECT_EQ(run.status, 2) << flags;
        EXPECT_NE(run.err.find(why), std::string::npos) << run.err;
    };
    refuse("/a.png --layers depth", "end it in .exr");
    refuse("/a.exr --layers depth,colour", "depth,tangent,id,mask; got 'colour'");
    refuse("/a.tif", ".png or .exr");
    refuse("/a.png --stroke wide", "--stroke");
    refuse("/a.png --widen 0", "--widen");
}

TEST(RenderCommand, DrawsEveryStrokeAndATransparentBackground) {
    const std::string folder = freshFolder();
    writeText(folder + "/a.toml", smallStyle());
    const std::string command =
        "render " + folder + "/a.toml -o " + folder + "/a.png --size 64x64 ";
    std::vector<std::string> pictures;
    for (const char* flags : {"", "--stroke line", "--stroke analytic", "--widen 4", "--alpha"}) {
        const Outcome run = runKushi(std::string(command).append(flags));
        ASSERT_EQ(run.status, 0) << run.err;
        pictures.push_back(readBytes(folder + "/a.png"));
    }
    for (std::size_t i = 0; i < pictures.size(); ++i) {
        for (std::size_t j = 0; j < i; ++j)
            EXPECT_FALSE(pictures[i] == pictures[j]) << i << ' ' << j;
    }
    constexpr std::size_t colorType = 25;  // in the header
    EXPECT_EQ(pictures[0][colorType], 2);
    EXPECT_EQ(pictures[4][colorType], 6);
}

}  // namespace
}  // namespace kushi::test
