// SPDX-License-Identifier: Apache-2.0
#include "cli/program.h"

#include <filesystem>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

namespace kushi::test {
namespace {

using testing::HasSubstr;

// Every command refuses bad input with status 2 and one clear line per problem, and writes nothing.
void expectRefused(const std::string& folder, const std::string& arguments,
                   const std::string& message) {
    const Outcome run = runKushi(arguments);
    EXPECT_EQ(run.status, 2) << arguments << '\n' << run.err;
    EXPECT_THAT(run.err, HasSubstr(message)) << arguments;
    EXPECT_EQ(run.out, "") << arguments;
    for (const char* output : {"/out.hair", "/out.ply", "/out.png", "/out.json"}) {
        EXPECT_FALSE(std::filesystem::exists(folder + output)) << arguments;
    }
}

TEST(BadInput, AStyleWithProblemsIsRefusedByEveryCommand) {
    const std::string folder = freshFolder();
    const std::string style = folder + "/bad.toml";
    writeText(style,
              smallStyle() + "lenght = 3\n\n[[force]]\ndirection = \"sideways\"\nmagnitude = 1\n");
    const std::string where = style + ":14:1: error: ";
    for (const std::string& command :
         {"check " + style, "info " + style,
          "settle " + style + " -o " + folder + "/out.hair --report " + folder + "/out.json",
          "render " + style + " -o " + folder + "/out.png"}) {
        expectRefused(folder, command, where);
        expectRefused(folder, command, "length");
        expectRefused(folder, command, style + ":17:13: error: ");
    }
}

TEST(BadInput, AGroomWithProblemsIsRefusedByEveryCommand) {
    const std::string folder = freshFolder();
    const std::string groom = folder + "/bad.obj";
    writeText(groom, "v 0 0 0\nv 0 nan 0\nl 1 2\n");
    expectRefused(folder, "info " + groom, "bad.obj:2");
    expectRefused(folder, "convert " + groom + " " + folder + "/out.hair", "bad.obj:2");
    expectRefused(folder, "render " + groom + " -o " + folder + "/out.png", "bad.obj:2");
}

TEST(BadInput, MissingFilesAndFoldersAreNamed) {
    const std::string folder = freshFolder();
    expectRefused(folder, "check " + folder + "/none.toml", "none.toml");
    expectRefused(folder, "info " + folder + "/none.hair", "none.hair");
    std::filesystem::create_directory(folder + "/folder.toml");
    expectRefused(folder, "check " + folder + "/folder.toml", "folder.toml");
}

TEST(BadInput, AHeadThatIsMissingOrNoneIsNamed) {
    const std::string folder = freshFolder();
    const std::string style = folder + "/a.toml";
    writeText(style, smallStyle("collide = false\nmesh = \"heads/me.obj\""));
    std::filesystem::create_directory(folder + "/heads");
    const std::string head = folder + "/heads/me.obj";
    expectRefused(folder, "check " + style, head + ": error: ");
    writeText(head, "v 0 0 0\nv 30 0 0\nv 0 0.25 0\nf 1 2 3\n");
    for (const std::string& command :
         {"check " + style, "render " + style + " -o " + folder + "/out.png"}) {
        expectRefused(folder, command, head + ": error: the mesh is 0.25 cm high");
    }
    writeText(head, "v 0 0 0\nv 30 0 0\nf 1 2 3\n");
    expectRefused(folder, "check " + style, head + ":3: error: vertex '3' does not exist");
    // Where nothing is drawn and nothing kept out of it, the head is not needed.
    EXPECT_EQ(runKushi("info " + style).status, 0);
}

TEST(BadInput, AGroomHasAsManyStrandsAsItHas) {
    const std::string folder = freshFolder();
    writeText(folder + "/a.obj", "v 0 0 0\nv 0 1 0\nl 1 2\n");
    expectRefused(folder, "settle " + folder + "/a.obj --count 5 -o " + folder + "/out.hair",
                  "for styles");
    expectRefused(folder, "render " + folder + "/a.obj --count 5 -o " + folder + "/out.png",
                  "for styles");
}

}  // namespace
}  // namespace kushi::test
