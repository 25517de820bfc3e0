// SPDX-License-Identifier: Apache-2.0
#include "cli/program.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

namespace kushi::test {
namespace {

using Size = std::pair<std::uint32_t, std::uint32_t>;

class SheetCommand : public testing::Test {
protected:
    void SetUp() override { writeText(style, smallStyle()); }

    // Size of the sheet of `inputs` styles in pictures of 50 x 40.
    Size sheetOf(int inputs, const std::string& flags) const {
        std::string arguments = "sheet";
        for (int i = 0; i < inputs; ++i)
            arguments += ' ' + style;
        const Outcome run = runKushi(arguments + " -o " + output +
                                     " --cell 50x40 --supersample 1 --count 20 " + flags);
        EXPECT_EQ(run.status, 0) << run.err;
        return pngSize(readBytes(output));
    }

    std::string folder = freshFolder();
    std::string style = folder + "/a.toml";
    std::string output = folder + "/sheet.png";
};

TEST_F(SheetCommand, PutsOneViewOfEachIntoABlock) {
    EXPECT_EQ(sheetOf(1, ""), Size(50, 40));
    EXPECT_EQ(sheetOf(2, ""), Size(2 * 50 + 6, 40));
    EXPECT_EQ(sheetOf(5, "--views front"), Size(3 * 50 + 2 * 6, 2 * 40 + 6));
}

TEST_F(SheetCommand, GivesEachStyleARowOfViews) {
    EXPECT_EQ(sheetOf(1, "--views front/right/back/30,10"), Size(4 * 50 + 3 * 6, 40));
    EXPECT_EQ(sheetOf(2, "--views front/left"), Size(2 * 50 + 6, 2 * 40 + 6));
}

TEST_F(SheetCommand, WritesNothingIfAStyleIsBad) {
    writeText(folder + "/bad.toml", "kushi = 2\n");
    const Outcome run = runKushi("sheet " + style + ' ' + folder + "/bad.toml -o " + output);
    EXPECT_EQ(run.status, 2);
    EXPECT_THAT(run.err, testing::HasSubstr("bad.toml:1:9: error: "));
    EXPECT_EQ(readBytes(output), "");
}

}  // namespace
}  // namespace kushi::test
