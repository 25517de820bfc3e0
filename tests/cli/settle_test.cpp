// SPDX-License-Identifier: Apache-2.0
#include "cli/program.h"

#include <kushi/groom_io.h>

#include <filesystem>

#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

namespace kushi::test {
namespace {

using nlohmann::json;

TEST(SettleCommand, WritesEveryFormatWithTheSameStrands) {
    const std::string folder = freshFolder();
    writeText(folder + "/a.toml", smallStyle());
    const Outcome hair = runKushi("settle " + folder + "/a.toml -o " + folder + "/a.hair");
    ASSERT_EQ(hair.status, 0) << hair.err;
    EXPECT_EQ(hair.err, "");  // no progress bar in a pipe
    ASSERT_EQ(runKushi("settle " + folder + "/a.toml -o " + folder + "/a.ply").status, 0);
    ASSERT_EQ(runKushi("convert " + folder + "/a.hair " + folder + "/a.obj").status, 0);

    const Strands reference = *readGroom(folder + "/a.hair");
    ASSERT_EQ(reference.size(), 200U);
    for (const char* name : {"/a.ply", "/a.obj"}) {
        const Strands other = *readGroom(folder + name);
        ASSERT_EQ(other.offsets, reference.offsets) << name;
        for (std::size_t i = 0; i < other.nodes.size(); ++i) {
            ASSERT_LT(length(other.nodes[i] - reference.nodes[i]), 1e-7F) << name;
        }
    }
}

TEST(SettleCommand, TheSameStyleGivesTheSameBytes) {
    const std::string folder = freshFolder();
    writeText(folder + "/a.toml", smallStyle());
    expectTheSameFromAnyThreads(folder + "/a.toml", folder + "/a.hair");
}

TEST(SettleCommand, CountSegmentsAndReport) {
    const std::string folder = freshFolder();
    writeText(folder + "/a.toml", smallStyle());
    const Outcome run = runKushi("settle " + folder + "/a.toml -o " + folder +
                                 "/a.hair --count 50 --segments 10 --report " + folder + "/r.json");
    ASSERT_EQ(run.status, 0) << run.err;
    const json report = json::parse(readBytes(folder + "/r.json"));
    EXPECT_EQ(report["strands"], 50);
    EXPECT_EQ(report["segments"], 500);
    EXPECT_GE(report["max_penetration_cm"], 0);
    EXPECT_EQ(report["unsettled"], 0);
    for (const char* stage : {"read", "plant", "settle", "write", "total"}) {
        EXPECT_TRUE(report["wall_ms"][stage].is_number()) << stage;
    }
}

TEST(InfoCommand, DescribesStylesAndGroomsAlike) {
    const std::string folder = freshFolder();
    writeText(folder + "/a.toml", smallStyle());
    ASSERT_EQ(runKushi("settle " + folder + "/a.toml -o " + folder + "/a.ply").status, 0);
    const json style = json::parse(runKushi("info --json " + folder + "/a.toml").out);
    const json groom = json::parse(runKushi("info --json " + folder + "/a.ply").out);
    for (const json& info : {style, groom}) {
        EXPECT_EQ(info["strands"], 200);
        EXPECT_EQ(info["segments"], 4800);
        EXPECT_EQ(info["nodes"], 5000);
        EXPECT_NEAR(info["length_cm"]["mean"].get<double>(), 20, 1e-4);
        EXPECT_LT(info["bounds_cm"]["min"][1].get<double>(), 0);
        EXPECT_TRUE(info["attributes"].is_array());
    }
    EXPECT_THAT(runKushi("info " + folder + "/a.toml").out, testing::HasSubstr("strands     200"));
}

TEST(SettleCommand, AReportNeverReplacesAStyleOrGroom) {
    const std::string folder = freshFolder();
    writeText(folder + "/a.toml", smallStyle());
    const std::string settle =
        "settle " + folder + "/a.toml -o " + folder + "/a.hair --report " + folder;
    EXPECT_EQ(runKushi(settle + "/a.toml").status, 2);
    EXPECT_EQ(runKushi(settle + "/none/r.json").status, 1);
    EXPECT_FALSE(std::filesystem::exists(folder + "/a.hair"));
    EXPECT_EQ(readBytes(folder + "/a.toml"), smallStyle());
}

TEST(SettleCommand, ACutThatLeavesNothingIsSaid) {
    const std::string folder = freshFolder();
    writeText(folder + "/a.toml", smallStyle() + "[[cut]]\nbelow = 50\n");
    const Outcome run = runKushi("settle " + folder + "/a.toml -o " + folder + "/a.hair");
    EXPECT_EQ(run.status, 2);
    EXPECT_THAT(run.err, testing::HasSubstr("no hair is left"));
}

TEST(SettleCommand, OutputThatCannotBePrintedIsAFailure) {
    const std::string folder = freshFolder();
    writeText(folder + "/a.toml", smallStyle());
    const std::string command =
        std::string(KUSHI_PROGRAM) + " info " + folder + "/a.toml >/dev/full 2>/dev/null";
    EXPECT_EQ(WEXITSTATUS(std::system(command.c_str())), 1);
}

TEST(SettleCommand, OutputsAppearWholeOrNotAtAll) {
    const std::string folder = freshFolder();
    writeText(folder + "/a.toml", smallStyle());
    EXPECT_EQ(runKushi("settle " + folder + "/a.toml -o " + folder + "/none/a.hair").status, 1);
    // A limit of 1 KiB on the size of files stands for a full disk.
    writeText(folder + "/a.hair", "precious");
    const std::string program = KUSHI_PROGRAM;
    const std::string limited = "sh -c 'ulimit -f 2; exec " + program + " settle " + folder +
                                "/a.toml -o " + folder + "/a.hair' 2>" + folder + "/err";
    const int raw = std::system(limited.c_str());
    EXPECT_EQ(WEXITSTATUS(raw), 1);
    EXPECT_THAT(readBytes(folder + "/err"), testing::HasSubstr("a.hair"));
    EXPECT_EQ(readBytes(folder + "/a.hair"), "precious");
    std::size_t files = 0;
    for ([[maybe_unused]] const auto& entry : std::filesystem::directory_iterator(folder))
        ++files;
    EXPECT_EQ(files, 3U);  // the style, the groom, the messages
}

}  // namespace
}  // namespace kushi::test
