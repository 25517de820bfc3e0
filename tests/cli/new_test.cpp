// SPDX-License-Identifier: Apache-2.0
#include "cli/program.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

namespace kushi::test {
namespace {

using testing::HasSubstr;

TEST(NewCommand, WritesAStyleThatIsGoodAndHasComments) {
    const std::string folder = freshFolder();
    const std::string path = folder + "/mine.toml";
    const Outcome run = runKushi("new " + path);
    EXPECT_EQ(run.status, 0) << run.err;
    EXPECT_THAT(run.out, HasSubstr("kushi render " + path));
    EXPECT_THAT(readBytes(path), HasSubstr("# "));

    const Outcome check = runKushi("check " + path);
    EXPECT_EQ(check.status, 0) << check.err;
    const Outcome info = runKushi("info " + path);
    EXPECT_EQ(info.status, 0) << info.err;
}

TEST(NewCommand, LeavesAFileThatExistsAlone) {
    const std::string folder = freshFolder();
    const std::string path = folder + "/mine.toml";
    writeText(path, "my work");
    const Outcome run = runKushi("new " + path);
    EXPECT_EQ(run.status, 2);
    EXPECT_THAT(run.err, HasSubstr(path + ": error: exists already"));
    EXPECT_EQ(readBytes(path), "my work");
}

TEST(NewCommand, SaysThatThereIsNoSuchFolder) {
    const Outcome run = runKushi("new " + freshFolder() + "/nowhere/mine.toml");
    EXPECT_EQ(run.status, 1);
    EXPECT_THAT(run.err, HasSubstr("there is no folder"));
}

// The README shows the style that the program writes.
TEST(NewCommand, WritesWhatTheReadmeShows) {
    const std::string path = freshFolder() + "/my-bob.toml";
    ASSERT_EQ(runKushi("new " + path).status, 0);
    const std::string readme = readBytes(std::string(KUSHI_SOURCE_DIR) + "/README.md");
    EXPECT_THAT(readme, HasSubstr("```toml\n" + readBytes(path) + "```"));
}

}  // namespace
}  // namespace kushi::test
