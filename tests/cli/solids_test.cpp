// SPDX-License-Identifier: Apache-2.0
//
// Hair kept out of solids, and grooms pushed out of them, by the program.
#include "cli/program.h"

#include <kushi/groom_io.h>

#include <filesystem>

#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

namespace kushi::test {
namespace {

namespace fs = std::filesystem;
using nlohmann::json;
using testing::HasSubstr;

// A block, 10 cm wide and 20 cm high, with its top 5 cm above the origin.
constexpr const char* block = R"(v -5 -15 -5
v 5 -15 -5
v 5 5 -5
v -5 5 -5
v -5 -15 5
v 5 -15 5
v 5 5 5
v -5 5 5
f 1 4 3 2
f 5 6 7 8
f 1 2 6 5
f 4 8 7 3
f 1 5 8 4
f 2 3 7 6
)";

// Hair that would hang through the block, which alone is in its way.
std::string blockStyle() {
    return R"(kushi = 1

[head]
mesh = "none"

[[collider]]
mesh = "block.obj"

[solver]
method = "equilibrium"
segments = 16

[scalp]
ellipsoid = { center = [0, 6, 0], semi_axes = [2, 1, 2] }
count = 60
regions = [ { theta = [0, 90] } ]

[hair]
length = 16
)";
}

// The block, its style, and a groom of two strands of 16 cm, one of them through it, aslant and
// nowhere as near to one face as to another.
std::string folderWithBlock() {
    const std::string folder = freshFolder();
    writeText(folder + "/block.obj", block);
    writeText(folder + "/a.toml", blockStyle());
    Strands groom;
    std::vector<Vec3f> nodes;
    for (const float y : {0.0F, 0.2F}) {
        nodes.clear();
        for (int j = 0; j <= 16; ++j)
            nodes.push_back(Vec3f{-0.078F, y, 0.013F} +
                            static_cast<float>(j) * Vec3f{0.0099F, 0, 0.00141F});
        groom.add(nodes, 0);
    }
    groom.keys.clear();
    EXPECT_TRUE(writeGroom(groom, folder + "/g.hair").ok());
    return folder;
}

std::vector<std::string> fieldsIn(const std::string& folder) {
    std::vector<std::string> files;
    if (!fs::is_directory(folder + "/.kushi")) return files;
    for (const auto& entry : fs::directory_iterator(folder + "/.kushi"))
        files.push_back(entry.path());
    return files;
}

bool inBlock(Vec3f place) {
    return std::max({std::abs(place.x), std::abs(place.y + 0.05F) - 0.05F, std::abs(place.z)}) <
           0.05F;
}

TEST(SettleCommand, KeepsHairOutOfSolidsAndReportsIt) {
    const std::string folder = folderWithBlock();
    const Outcome run = runKushi("settle " + folder + "/a.toml -o " + folder + "/a.hair --report " +
                                 folder + "/r.json");
    ASSERT_EQ(run.status, 0) << run.err;
    const json report = json::parse(readBytes(folder + "/r.json"));
    EXPECT_NEAR(report["solids_spacing_cm"].get<double>(), 0.25, 1e-6);
    EXPECT_GE(report["pushed_out"], 0);
    EXPECT_EQ(report["stuck"], 0);
    ASSERT_EQ(report["penetration"].size(), 1U);
    EXPECT_EQ(report["penetration"][0]["part"], "hair");
    EXPECT_EQ(report["penetration"][0]["strands"], 0);
    EXPECT_LT(report["penetration"][0]["deepest_cm"], 0.01);
    EXPECT_EQ(report["max_penetration_cm"], report["penetration"][0]["deepest_cm"]);
    EXPECT_TRUE(report["wall_ms"]["solids"].is_number());
    int below = 0;
    const Strands groom = *readGroom(folder + "/a.hair");
    for (const Vec3f node : groom.nodes) {
        EXPECT_FALSE(inBlock(node));
        below += node.y < 0 ? 1 : 0;
    }
    EXPECT_GT(below, 60);  // it does hang beside it

    writeText(
        folder + "/free.toml",
        blockStyle().replace(blockStyle().find("[[collider]]\nmesh = \"block.obj\"\n"), 32, ""));
    ASSERT_EQ(runKushi("settle " + folder + "/free.toml -o " + folder + "/f.hair --report " +
                       folder + "/f.json")
                  .status,
              0);
    const json free = json::parse(readBytes(folder + "/f.json"));
    EXPECT_FALSE(free.contains("solids_spacing_cm"));
    EXPECT_EQ(free["pushed_out"], 0);
    const std::vector<Vec3f> nodes = readGroom(folder + "/f.hair")->nodes;
    EXPECT_GT(std::ranges::count_if(nodes, inBlock), 30);
}

TEST(SettleCommand, KeepsItsDistanceFieldBesideTheStyle) {
    const std::string folder = folderWithBlock();
    const std::string settle = "settle " + folder + "/a.toml -o " + folder + "/a.hair";
    ASSERT_EQ(runKushi(settle).status, 0);
    const std::vector<std::string> files = fieldsIn(folder);
    ASSERT_EQ(files.size(), 1U);
    EXPECT_EQ(fs::path(files[0]).extension(), ".field");
    const std::string groom = readBytes(folder + "/a.hair");
    const std::string field = readBytes(files[0]);
    const auto written = fs::last_write_time(files[0]);
    ASSERT_EQ(runKushi(settle).status, 0);
    EXPECT_EQ(fs::last_write_time(files[0]), written);

    // Cut short, changed in the middle, or something else: it is made anew, and nobody complains.
    std::string changed = field;
    changed[field.size() / 2] = static_cast<char>(changed[field.size() / 2] ^ 1);
    for (const std::string& damaged :
         {std::string(), field.substr(0, 20), field.substr(0, field.size() - 1), changed,
          std::string("no field")}) {
        writeText(files[0], damaged);
        const Outcome run = runKushi(settle);
        EXPECT_EQ(run.status, 0);
        EXPECT_EQ(run.err, "");
        EXPECT_TRUE(readBytes(folder + "/a.hair") == groom);
        EXPECT_TRUE(readBytes(files[0]) == field);
    }
    // Another gap is another field.
    std::string wider = blockStyle();
    wider.insert(wider.find("[solver]"), "gap = 0.5\n\n");
    writeText(folder + "/a.toml", wider);
    ASSERT_EQ(runKushi(settle).status, 0);
    EXPECT_EQ(fieldsIn(folder).size(), 2U);
}

TEST(SettleCommand, DoesWithoutAPlaceForItsDistanceField) {
    const std::string folder = folderWithBlock();
    fs::create_directory(folder + "/out");
    const std::string settle = "settle " + folder + "/a.toml -o " + folder + "/out/a.hair";
    // A file in its place, which not even root can write into.
    writeText(folder + "/.kushi", "mine");
    Outcome run = runKushi(settle);
    EXPECT_EQ(run.status, 0);
    EXPECT_EQ(run.err, "");
    EXPECT_EQ(readBytes(folder + "/.kushi"), "mine");
    const std::string groom = readBytes(folder + "/out/a.hair");

    fs::remove(folder + "/.kushi");
    fs::permissions(folder, fs::perms::owner_read | fs::perms::owner_exec);
    run = runKushi(settle);
    fs::permissions(folder, fs::perms::owner_all);
    EXPECT_EQ(run.status, 0);
    EXPECT_EQ(run.err, "");
    EXPECT_TRUE(readBytes(folder + "/out/a.hair") == groom);
}

TEST(CheckCommand, TellsHowFarHairIsInside) {
    const std::string folder = folderWithBlock();
    Outcome run = runKushi("check " + folder + "/a.toml --penetration");
    EXPECT_EQ(run.status, 0) << run.err;
    EXPECT_THAT(run.out, HasSubstr("a.toml: good"));
    EXPECT_THAT(run.out, HasSubstr("'hair': none is inside"));
    // Without being asked it settles nothing.
    run = runKushi("check " + folder + "/a.toml");
    EXPECT_EQ(run.status, 0);
    EXPECT_EQ(run.out.find("inside"), std::string::npos);
    run = runKushi("check " + folder + "/g.hair --solids " + folder + "/a.toml");
    EXPECT_EQ(run.status, 0) << run.err;
    // Where the strand is as far from the face beside it as from the one it came through.
    EXPECT_THAT(run.out, HasSubstr("1 strand inside, by 2.8"));
    // Of the mannequin: that strand goes through its brow as well.
    run = runKushi("check " + folder + "/g.hair");
    EXPECT_EQ(run.status, 0) << run.err;
    EXPECT_THAT(run.out, HasSubstr("1 strand inside, by "));
}

TEST(SettleGroomCommand, PushesStrandsOutWhereAsked) {
    const std::string folder = folderWithBlock();
    const std::string settle =
        "settle " + folder + "/g.hair -o " + folder + "/out.hair --report " + folder + "/r.json";
    const Outcome run = runKushi(settle + " --push-out --solids " + folder + "/a.toml");
    ASSERT_EQ(run.status, 0) << run.err;
    EXPECT_THAT(run.out, HasSubstr("pushed out: 1 strand"));
    EXPECT_EQ(run.out.find("not free"), std::string::npos);
    json report = json::parse(readBytes(folder + "/r.json"));
    EXPECT_EQ(report["pushed_out"], 1);
    EXPECT_EQ(report["stuck"], 0);
    EXPECT_THAT(runKushi("check " + folder + "/out.hair --solids " + folder + "/a.toml").out,
                HasSubstr("none is inside"));
    const Strands before = *readGroom(folder + "/g.hair");
    const Strands after = *readGroom(folder + "/out.hair");
    ASSERT_EQ(after.nodes.size(), before.nodes.size());
    EXPECT_EQ(after.nodes[0], before.nodes[0]);
    for (std::size_t i = 0; i < 2; ++i)
        EXPECT_NEAR(polylineLength(after.strand(i)), 0.16, 1e-5);
    // Its hair rests against the block, and that is what --solids alone says as well.
    EXPECT_LE(report["max_residual"], 1e-5);
    EXPECT_EQ(report["inside"], 0);
    EXPECT_LT(report["max_penetration_cm"], 0.01);
    const std::string bytes = readBytes(folder + "/out.hair");
    ASSERT_EQ(runKushi(settle + " --solids " + folder + "/a.toml --up y").status, 0);
    EXPECT_TRUE(readBytes(folder + "/out.hair") == bytes);
    // The other is where it settles anyway.
    ASSERT_EQ(runKushi(settle).status, 0);
    const Strands plain = *readGroom(folder + "/out.hair");
    for (std::size_t j = 17; j < 34; ++j)
        EXPECT_EQ(after.nodes[j], plain.nodes[j]);
    EXPECT_FALSE(json::parse(readBytes(folder + "/r.json")).contains("pushed_out"));
}

TEST(SettleGroomCommand, PushesOutInTheFilesUnit) {
    const std::string folder = folderWithBlock();
    Strands groom = *readGroom(folder + "/g.hair");
    for (Vec3f& node : groom.nodes)
        node *= 0.1F;  // as if it were in decimetres
    ASSERT_TRUE(writeGroom(groom, folder + "/small.hair").ok());
    const std::string rest = " --push-out --solids " + folder + "/a.toml";
    ASSERT_EQ(runKushi("settle " + folder + "/g.hair -o " + folder + "/a.hair" + rest).status, 0);
    ASSERT_EQ(runKushi("settle " + folder + "/small.hair --unit 10 -o " + folder + "/b.hair" + rest)
                  .status,
              0);
    const Strands a = *readGroom(folder + "/a.hair");
    const Strands b = *readGroom(folder + "/b.hair");
    for (std::size_t j = 0; j < a.nodes.size(); ++j)
        EXPECT_LT(length(a.nodes[j] - 10 * b.nodes[j]), 1e-3F);
}

TEST(Solids, WrongUseIsSaidAndNothingWritten) {
    const std::string folder = folderWithBlock();
    writeText(folder + "/free.toml", smallStyle("mesh = \"none\""));
    writeText(folder + "/lost.toml",
              blockStyle().replace(blockStyle().find("block.obj"), 9, "no.obj"));
    writeText(folder + "/bad.toml", "kushi = 1\nnonsense = 2\n");
    struct Case {
        const char *command, *arguments, *says;
    };
    for (const auto& [command, arguments, says] : {
             Case{"settle", "g.hair --push-out --up z", "stands upright"},
             Case{"settle", "g.hair --solids @/a.toml --up -y", "stands upright"},
             Case{"settle", "g.hair --push-out --solids @/none.toml", "none.toml"},
             Case{"settle", "g.hair --push-out --solids @/bad.toml", "bad.toml:2"},
             Case{"settle", "g.hair --push-out --solids @/free.toml",
                  "nothing to keep hair out of"},
             Case{"settle", "g.hair --push-out --solids @/lost.toml", "no.obj"},
             Case{"settle", "a.toml --push-out", "are for grooms"},
             Case{"settle", "a.toml --solids @/a.toml", "are for grooms"},
             Case{"settle", "lost.toml", "no.obj"},
             Case{"check", "lost.toml", "no.obj"},
             Case{"check", "a.toml --solids @/a.toml", "--solids is for grooms"},
             Case{"check", "g.hair --solids @/none.toml", "none.toml"},
             Case{"check", "g.hair --solids @/free.toml", "nothing to keep hair out of"},
             Case{"check", "none.hair", "none.hair"},
         }) {
        std::string all = std::string(command) + " " + folder + "/" + arguments;
        if (const std::size_t at = all.find('@'); at != std::string::npos)
            all.replace(at, 1, folder);
        if (std::string(command) == "settle") all += " -o " + folder + "/out.obj";
        const Outcome run = runKushi(all);
        EXPECT_EQ(run.status, 2) << arguments;
        EXPECT_THAT(run.err, HasSubstr(says)) << arguments;
        EXPECT_EQ(run.out, "") << arguments;
        EXPECT_FALSE(fs::exists(folder + "/out.obj")) << arguments;
    }
}

}  // namespace
}  // namespace kushi::test
