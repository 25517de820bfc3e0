// SPDX-License-Identifier: Apache-2.0
#include "cli/program.h"
#include "farthest.h"

#include <kushi/groom_io.h>

#include <cmath>

#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

namespace kushi::test {
namespace {

using nlohmann::json;
using testing::HasSubstr;

// Two arcs of 15 cm with colours and diameters, as .ply and .hair.
std::string folderWithGroom() {
    const std::string folder = freshFolder();
    Strands groom;
    std::vector<Vec3f> nodes;
    for (const float side : {-0.1F, 0.1F}) {
        nodes.clear();
        for (int j = 0; j <= 15; ++j) {
            const float a = 0.1F * static_cast<float>(j);
            nodes.push_back({0.1F * std::sin(a), 0.1F * std::cos(a), side});
        }
        groom.add(nodes, 0);
    }
    groom.keys.clear();
    groom.colors.assign(groom.nodes.size(), Rgb{0.2F, 0.4F, 0.6F});
    groom.diameters.assign(groom.nodes.size(), 80e-6F);
    EXPECT_TRUE(writeGroom(groom, folder + "/g.hair").ok());
    EXPECT_TRUE(writeGroom(groom, folder + "/g.obj").ok());
    return folder;
}

TEST(SettleGroomCommand, ASetGroomStaysPutAndIsReported) {
    const std::string folder = folderWithGroom();
    const Outcome run = runKushi("settle " + folder + "/g.hair -o " + folder +
                                 "/same.ply --report " + folder + "/r.json");
    ASSERT_EQ(run.status, 0) << run.err;
    EXPECT_EQ(run.err, "");
    const Strands before = *readGroom(folder + "/g.hair");
    const Strands after = *readGroom(folder + "/same.ply");
    EXPECT_LT(farthest(before, after), 1e-4F * 0.15F);
    EXPECT_EQ(after.diameters.size(), after.nodes.size());
    EXPECT_NEAR(after.colors[3].g, 0.4F, 0.01F);

    const json report = json::parse(readBytes(folder + "/r.json"));
    EXPECT_EQ(report["strands"], 2);
    EXPECT_EQ(report["segments"], 30);
    EXPECT_EQ(report["unsettled"], 0);
    EXPECT_LE(report["max_residual"], 1e-5);
    // Both arcs stand up from their roots: free hair of this length would topple sideways.
    EXPECT_EQ(report["set"]["unstable"], 2);
    EXPECT_EQ(report["set"]["stiffened"], 2);
    EXPECT_EQ(report["set"]["unheld"], 0);
    EXPECT_GT(report["set"]["stiffened_median"], 1.25);
    EXPECT_EQ(report["set"]["stiffened_max"], report["set"]["stiffened_median"]);
    for (const char* stage : {"read", "set", "settle", "write", "total"})
        EXPECT_TRUE(report["wall_ms"][stage].is_number()) << stage;
}

TEST(SettleGroomCommand, GravityWeightStiffnessAndSetChangeIt) {
    const std::string folder = folderWithGroom();
    const auto tip = [&](const std::string& flags) {
        const std::string out = folder + "/out.obj";
        EXPECT_EQ(runKushi("settle " + folder + "/g.obj -o " + out + " " + flags).status, 0);
        return readGroom(out)->strand(0).back().y;
    };
    const float before = tip("");
    EXPECT_LT(tip("--weight-scale 1.5"), before - 0.002F);
    EXPECT_GT(tip("--stiffness-scale 1.5"), before + 0.002F);
    EXPECT_GT(tip("--gravity 0,1,0"), before + 0.05F);
    EXPECT_GT(tip("--gravity=0,-0.5,0"), before + 0.002F);
    EXPECT_GT(std::abs(tip("--set 0") - before), 0.002F);
    EXPECT_NEAR(tip("--set 1 --weight-scale 1 --gravity 0,-1,0 --method equilibrium"), before,
                1e-6F);
}

TEST(SettleGroomCommand, UnitAndUpSayHowTheFileIsMeant) {
    const std::string folder = folderWithGroom();
    // The same in millimetres and z up.
    Strands other = *readGroom(folder + "/g.obj");
    for (Vec3f& node : other.nodes)
        node = 10.0F * Vec3f{node.z, node.x, node.y};
    ASSERT_TRUE(writeGroom(other, folder + "/mm.obj").ok());
    ASSERT_EQ(
        runKushi("settle " + folder + "/g.obj -o " + folder + "/a.obj --weight-scale 1.5").status,
        0);
    const Outcome run = runKushi("settle " + folder + "/mm.obj -o " + folder +
                                 "/b.obj --weight-scale 1.5 --up z --unit 0.1");
    ASSERT_EQ(run.status, 0) << run.err;
    const Strands a = *readGroom(folder + "/a.obj");
    Strands b = *readGroom(folder + "/b.obj");
    for (Vec3f& node : b.nodes)
        node = 0.1F * Vec3f{node.y, node.z, node.x};
    EXPECT_LT(farthest(a, b), 1e-3F * 0.15F);
}

TEST(SettleGroomCommand, WhatDoesNotFitIsSaidAndNothingWritten) {
    const std::string folder = folderWithGroom();
    writeText(folder + "/a.toml", smallStyle());
    struct Case {
        const char *arguments, *says;
    };
    for (const auto& [arguments, says] : {
             Case{"g.hair --count 1", "--count and --segments are for styles"},
             Case{"g.hair --segments 8", "--count and --segments are for styles"},
             Case{"g.hair --method cantilever", "leave --method out"},
             Case{"g.hair --gravity 0,1", "give X,Y,Z"},
             Case{"g.hair --gravity 0,1,0,0", "give X,Y,Z"},
             Case{"g.hair --gravity 0,nan,0", "give X,Y,Z"},
             Case{"g.hair --gravity down", "give X,Y,Z"},
             Case{"g.hair --up w", "give x, y, z"},
             Case{"g.hair --set 1.1", "from 0 to 1"},
             Case{"g.hair --set nan", "from 0 to 1"},
             Case{"g.hair --weight-scale 0", "from 0.001"},
             Case{"g.hair --stiffness-scale -1", "from 0.001"},
             Case{"g.hair --unit 0", "from 0.0001"},
             Case{"a.toml --gravity 0,1,0", "are for grooms"},
             Case{"a.toml --set 1", "are for grooms"},
             Case{"a.toml --weight-scale 2", "are for grooms"},
             Case{"a.toml --stiffness-scale 2", "are for grooms"},
             Case{"a.toml --up z", "are for grooms"},
             Case{"a.toml --unit 2", "are for grooms"},
             Case{"none.hair", "none.hair"},
         }) {
        const Outcome run =
            runKushi("settle " + folder + "/" + arguments + " -o " + folder + "/out.obj");
        EXPECT_EQ(run.status, 2) << arguments;
        EXPECT_THAT(run.err, HasSubstr(says)) << arguments;
        EXPECT_FALSE(readGroom(folder + "/out.obj").ok()) << arguments;
    }
}

TEST(SettleGroomCommand, TheSameGroomGivesTheSameBytes) {
    const std::string folder = folderWithGroom();
    std::string first;
    for (const char* threads : {"1", "2", "8"}) {
        ASSERT_EQ(runKushi("settle " + folder + "/g.hair -o " + folder +
                           "/a.hair --gravity 1,0,0 --threads " + threads)
                      .status,
                  0);
        const std::string bytes = readBytes(folder + "/a.hair");
        if (first.empty()) first = bytes;
        EXPECT_TRUE(bytes == first) << threads;
    }
}

}  // namespace
}  // namespace kushi::test
