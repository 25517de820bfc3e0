// SPDX-License-Identifier: Apache-2.0
#include "cli/program.h"

#include <gtest/gtest.h>

namespace kushi::test {
namespace {

std::uint32_t bigEndian(const std::string& bytes, std::size_t at) {
    std::uint32_t value = 0;
    for (std::size_t i = 0; i < 4; ++i)
        value = value << 8U | static_cast<unsigned char>(bytes[at + i]);
    return value;
}

TEST(RenderCommand, WritesAPngOfTheSizeAskedForAndTheSameBytesFromAnyThreads) {
    const std::string folder = freshFolder();
    writeText(folder + "/a.toml", smallStyle());
    std::string first;
    for (const char* threads : {"1", "2", "8"}) {
        const Outcome run = runKushi("render " + folder + "/a.toml -o " + folder +
                                     "/a.png --size 200x100 --threads " + threads);
        ASSERT_EQ(run.status, 0) << run.err;
        const std::string bytes = readBytes(folder + "/a.png");
        ASSERT_EQ(bytes.substr(1, 3), "PNG");
        EXPECT_EQ(bigEndian(bytes, 16), 200U);
        EXPECT_EQ(bigEndian(bytes, 20), 100U);
        if (first.empty()) first = bytes;
        EXPECT_TRUE(bytes == first) << threads;
    }
}

TEST(RenderCommand, DrawsAHeadFromAFileBesideTheStyle) {
    const std::string folder = freshFolder();
    const auto render = [&](const std::string& head, const std::string& name) {
        writeText(folder + "/" + name + ".toml", smallStyle() + head);
        const Outcome run = runKushi("render " + folder + "/" + name + ".toml -o " + folder + "/" +
                                     name + ".png --size 64x64");
        EXPECT_EQ(run.status, 0) << run.err;
        return readBytes(folder + "/" + name + ".png");
    };
    writeText(folder + "/head.obj",
              "v 0 0 0\nv 20 0 0\nv 0 30 0\nv 0 0 20\nf 1 3 2\nf 1 2 4\n"
              "f 1 4 3\nf 2 3 4\n");
    const std::string bare = render("[head]\nmesh = \"none\"\n", "bare");
    const std::string pointed = render("[head]\nmesh = \"head.obj\"\n", "pointed");
    EXPECT_FALSE(bare == pointed);
    EXPECT_EQ(runKushi("check " + folder + "/pointed.toml").status, 0);
}

TEST(RenderCommand, DrawsGroomsMadeElsewhere) {
    const std::string folder = freshFolder();
    writeText(folder + "/a.obj", "v 0 0 0\nv 1 1 0\nv 1 2 3\nl 1 2 3\n");
    const Outcome run = runKushi("render " + folder + "/a.obj -o " + folder +
                                 "/a.png --size 64x64 --view 30,10 --supersample 1");
    EXPECT_EQ(run.status, 0) << run.err;
    EXPECT_EQ(readBytes(folder + "/a.png").substr(1, 3), "PNG");
}

}  // namespace
}  // namespace kushi::test
