// SPDX-License-Identifier: Apache-2.0
#include "cli/program.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

namespace kushi::test {
namespace {

using testing::HasSubstr;
using testing::StartsWith;

TEST(Usage, VersionIsOneLine) {
    const Outcome run = runKushi("--version");
    EXPECT_EQ(run.status, 0);
    EXPECT_THAT(run.out, StartsWith("kushi 0."));
}

TEST(Usage, HelpTeaches) {
    const Outcome run = runKushi("--help");
    EXPECT_EQ(run.status, 0);
    for (const char* command :
         {"new", "check", "settle", "render", "sheet", "convert", "info", "rod"}) {
        EXPECT_THAT(run.out, HasSubstr(std::string("\n  ") + command));
        const Outcome help = runKushi(std::string(command) + " --help");
        EXPECT_EQ(help.status, 0);
        EXPECT_THAT(help.out, HasSubstr("Usage:"));
    }
    EXPECT_THAT(run.out, HasSubstr("kushi render styles/fig10-bob.toml"));
}

TEST(Usage, MistakesAreOneLineAndStatusTwo) {
    for (const char* arguments : {"",
                                  "comb",
                                  "settle",
                                  "settle a.toml",
                                  "render a.toml -o b.png --supersample 3",
                                  "render a.toml -o b.png --threads 0",
                                  "render a.toml -o b.png --size 12",
                                  "render a.toml -o b.png --size 0x5",
                                  "render a.toml -o b.png --size 5x5x",
                                  "render a.toml -o b.png --view sideways",
                                  "render a.toml -o b.jpg",
                                  "render a.toml -o b.png --engine magic",
                                  "render a.toml -o b.png --spp 4",
                                  "render a.toml -o b.png --engine raster --seed 4",
                                  "render a.toml -o b.png --engine path --spp 0",
                                  "render a.toml -o b.png --engine path --bounces -1",
                                  "render a.toml -o b.png --engine path --noise nan",
                                  "render a.toml -o b.png --engine path --look paper",
                                  "sheet a.toml",
                                  "sheet a.toml -o b.jpg",
                                  "sheet a.toml -o b.png --cell 5",
                                  "sheet a.toml -o b.png --views front/sideways",
                                  "sheet a.toml -o b.png --cell 16384x9 --views front/back",
                                  "new",
                                  "new a.txt",
                                  "settle a.toml -o b.abc",
                                  "settle a.toml -o b.hair --segments 257",
                                  "settle a.toml -o b.hair --count 0",
                                  "settle a.toml -o b.hair --count many",
                                  "settle a.toml -o b.hair --method magic",
                                  "convert a.hair",
                                  "convert a.hair b.abc",
                                  "info a.txt",
                                  "info",
                                  "check",
                                  "rod --length -1",
                                  "rod --segments 0",
                                  "rod --method magic",
                                  "rod --angle 181",
                                  "rod --length nan",
                                  "info --jsn a.hair",
                                  "check a.toml b.toml"}) {
        const Outcome run = runKushi(arguments);
        EXPECT_EQ(run.status, 2) << arguments;
        EXPECT_EQ(run.out, "") << arguments;
        EXPECT_EQ(std::count(run.err.begin(), run.err.end(), '\n'), 1)
            << arguments << ": " << run.err;
        EXPECT_THAT(run.err, HasSubstr("error: ")) << arguments;
    }
}

}  // namespace
}  // namespace kushi::test
