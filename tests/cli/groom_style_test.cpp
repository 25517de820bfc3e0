// SPDX-License-Identifier: Apache-2.0
//
// Styles with a groom made elsewhere.
#include "cli/program.h"

#include <kushi/groom_io.h>

#include <cmath>

#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

namespace kushi::test {
namespace {

using nlohmann::json;
using testing::HasSubstr;

// A folder with g.hair, in which 20 strands stand up from a scalp and bend over, and a.toml.
std::string folderWithStyle(const std::string& more = "") {
    std::string folder = freshFolder();
    Strands groom;
    std::vector<Vec3f> nodes;
    for (int i = 0; i < 20; ++i) {
        nodes.clear();
        for (int j = 0; j <= 15; ++j) {
            const float a = 0.1F * static_cast<float>(j);
            nodes.push_back({0.1F * std::sin(a), 0.12F + 0.1F * std::cos(a) - 0.1F,
                             0.004F * static_cast<float>(i - 10)});
        }
        groom.add(nodes, 0);
    }
    groom.keys.clear();
    EXPECT_TRUE(writeGroom(groom, folder + "/g.hair").ok());
    writeText(folder + "/a.toml",
              "kushi = 1\ngroom = \"g.hair\"\n" + more + "[solver]\nmethod = \"equilibrium\"\n");
    return folder;
}

TEST(GroomStyleCommand, IsCheckedSettledReportedAndDrawn) {
    const std::string folder = folderWithStyle();
    const std::string style = folder + "/a.toml";
    const Outcome check = runKushi("check " + style);
    EXPECT_EQ(check.status, 0) << check.err;

    const Outcome run =
        runKushi("settle " + style + " -o " + folder + "/a.hair --report " + folder + "/r.json");
    ASSERT_EQ(run.status, 0) << run.err;
    EXPECT_EQ(run.err, "");
    EXPECT_THAT(run.out, HasSubstr("made stiffer to hold: 20 strands"));
    const Strands before = *readGroom(folder + "/g.hair");
    const Strands after = *readGroom(folder + "/a.hair");
    ASSERT_EQ(after.offsets, before.offsets);
    for (std::size_t j = 0; j < before.nodes.size(); ++j)
        EXPECT_LT(length(after.nodes[j] - before.nodes[j]), 1e-4F * 0.15F);
    const json report = json::parse(readBytes(folder + "/r.json"));
    EXPECT_EQ(report["strands"], 20);
    EXPECT_EQ(report["unsettled"], 0);
    EXPECT_LT(report["max_penetration_cm"], 0.01);
    EXPECT_LE(report["max_residual"], 1e-5);
    EXPECT_EQ(report["set"]["stiffened"], 20);
    EXPECT_GT(report["set"]["stiffened_median"], 1);
    EXPECT_GE(report["set"]["stiffened_max"], report["set"]["stiffened_median"]);
    EXPECT_EQ(report["set"]["unheld"], 0);
    EXPECT_GE(report["set"]["unstable"], 0);
    for (const char* stage : {"read", "plant", "set", "settle", "write", "total"})
        EXPECT_TRUE(report["wall_ms"][stage].is_number()) << stage;

    const json info = json::parse(runKushi("info --json " + style).out);
    EXPECT_EQ(info["strands"], 20);
    EXPECT_EQ(info["attributes"], (json{"key", "diameter", "color"}));

    const Outcome render = runKushi("render " + style + " -o " + folder + "/a.png --size 64x64" +
                                    " --count 7 --report " + folder + "/p.json");
    ASSERT_EQ(render.status, 0) << render.err;
    EXPECT_EQ(pngSize(readBytes(folder + "/a.png")).first, 64U);
    EXPECT_EQ(json::parse(readBytes(folder + "/p.json"))["strands"], 7);
}

TEST(GroomStyleCommand, GivesTheSameBytesFromAnyNumberOfThreads) {
    const std::string folder = folderWithStyle("gravity = [0, 1, 0.5]\n");
    expectTheSameFromAnyThreads(folder + "/a.toml", folder + "/a.hair");
    EXPECT_GT(readGroom(folder + "/a.hair")->strand(0).back().y, 0.15F);
}

TEST(GroomStyleCommand, SaysWhereTheStyleNamesABadGroom) {
    const std::string folder = folderWithStyle();
    const std::string style = folder + "/a.toml";
    const Outcome walk = runKushi("info " + style);
    EXPECT_EQ(walk.status, 0);
    const Outcome cantilever =
        runKushi("settle " + style + " -o " + folder + "/a.hair --method cantilever");
    EXPECT_EQ(cantilever.status, 2);
    EXPECT_THAT(cantilever.err, HasSubstr("a.toml: error: the hair of 'hair' is a groom"));

    std::string bytes = readBytes(folder + "/g.hair");
    bytes.resize(bytes.size() - 3);
    writeText(folder + "/g.hair", bytes);
    for (const std::string& command :
         {"check " + style, "info " + style, "settle " + style + " -o " + folder + "/a.ply",
          "render " + style + " -o " + folder + "/a.png"}) {
        const Outcome run = runKushi(command);
        EXPECT_EQ(run.status, 2) << command;
        EXPECT_THAT(run.err, HasSubstr("a.toml:2:1: error: groom: ")) << command;
        EXPECT_THAT(run.err, HasSubstr("g.hair: cut short")) << command;
    }
    EXPECT_EQ(readBytes(folder + "/a.ply"), "");
}

}  // namespace
}  // namespace kushi::test
