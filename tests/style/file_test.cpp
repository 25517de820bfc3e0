// SPDX-License-Identifier: Apache-2.0
#include <kushi/style.h>

#include <fstream>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

namespace kushi {
namespace {

using testing::HasSubstr;

std::string fileWith(const std::string& name, const std::string& bytes) {
    std::string path = testing::TempDir() + name;
    std::ofstream(path, std::ios::binary) << bytes;
    return path;
}

Problem onlyProblem(const Result<Style>& style) {
    EXPECT_FALSE(style.ok());
    if (style) return {};
    EXPECT_EQ(style.problems().size(), 1U);
    return style.problems()[0];
}

constexpr const char* smallest =
    "kushi = 1\n"
    "[scalp]\nellipsoid = { semi_axes = [10, 12, 8] }\nspacing = 0.5\n"
    "[hair]\nlength = 25\n";

TEST(StyleFile, IsRead) {
    const auto style = readStyle(fileWith("small.toml", smallest));
    ASSERT_TRUE(style) << toString(style.problems()[0]);
    EXPECT_EQ(style->parts.size(), 1U);
}

TEST(StyleFile, MayBeginWithAByteOrderMark) {
    EXPECT_TRUE(parseStyle(std::string("\xEF\xBB\xBF") + smallest, "f"));
    const Problem problem = onlyProblem(parseStyle("\xEF\xBB\xBF kushi = 2\n", "f"));
    EXPECT_EQ(problem.column, 10);
}

TEST(StyleFile, ThatIsMissingIsAProblemWithItsPath) {
    const std::string path = testing::TempDir() + "there-is-no-such.toml";
    const Problem problem = onlyProblem(readStyle(path));
    EXPECT_EQ(problem.file, path);
    EXPECT_EQ(problem.line, 0);
    EXPECT_FALSE(problem.system);
    EXPECT_THAT(problem.message, HasSubstr("cannot open the style: No such file or directory"));
}

TEST(StyleFile, ThatIsADirectoryIsAProblem) {
    const Problem problem = onlyProblem(readStyle(testing::TempDir()));
    EXPECT_THAT(problem.message, HasSubstr("found a directory"));
    EXPECT_FALSE(problem.system);
}

TEST(StyleFile, ThatIsHugeIsRefusedUnread) {
    const auto path = fileWith("huge.toml", smallest + std::string(std::size_t{5} << 20U, '\n'));
    const Problem problem = onlyProblem(readStyle(path));
    EXPECT_THAT(problem.message, HasSubstr("longer than 4 MiB"));
    EXPECT_EQ(problem.line, 0);
}

TEST(StyleFile, WithAZeroByteIsRefusedAtThatByte) {
    const Problem problem = onlyProblem(parseStyle(std::string("kushi = 1\nname\0= 2", 17), "f"));
    EXPECT_THAT(problem.message, HasSubstr("zero byte"));
    EXPECT_EQ(problem.line, 2);
    EXPECT_EQ(problem.column, 5);
}

TEST(StyleFile, ThatIsNotUtf8IsRefusedAtTheFirstWrongByte) {
    const char* const wrong[] = {
        "\xFF",              // never in UTF-8
        "\xC3 ",             // cut short
        "\xC0\xAF",          // too long a form
        "\xED\xA0\x80",      // half a surrogate pair
        "\xF4\x90\x80\x80",  // beyond Unicode
        "\xE6\xAB",          // cut short by the end
    };
    for (const char* bytes : wrong) {
        const auto style = parseStyle("# \xE6\xAB\x9B " + std::string(bytes), "f");
        const Problem problem = onlyProblem(style);
        EXPECT_THAT(problem.message, HasSubstr("expected text in UTF-8"));
        EXPECT_EQ(problem.line, 1);
        EXPECT_EQ(problem.column, 5);
    }
    const Problem problem = onlyProblem(parseStyle("\xFF\xFEk\1", "f"));
    EXPECT_THAT(problem.message, HasSubstr("UTF-16"));
}

TEST(StyleFile, CannotExhaustTheStack) {
    std::string headers;
    for (int i = 0; i < 100'000; ++i)
        headers += "a.";
    const std::string deep[] = {
        "a = " + std::string(1'000'000, '['),
        headers + "a = 1",
        "[" + headers + "a]",
        R"(x = { b = """q""""", )" + headers + "a = 1 }",
        "x = '''q''''' \n" + headers + "a = 1",
        "s = \"a # b\" \n" + headers + "a = 1",
    };
    for (const std::string& text : deep) {
        const Problem problem = onlyProblem(parseStyle(text, "f"));
        EXPECT_THAT(problem.message, testing::AnyOf(HasSubstr("dotted key of more than 32 parts"),
                                                    HasSubstr("nested too deeply")));
    }
}

TEST(StyleFile, MayHaveManyDotsWhereTheyNestNothing) {
    const std::string dots(200, '.');
    EXPECT_TRUE(parseStyle(
        "name = \"\"\"\"\xC3\xA9\\u00E9 \\\n \\\"" + dots + "\"\"\"\"\n" + smallest, "f"));
    EXPECT_TRUE(
        parseStyle("# " + dots + "\nname = \"" + dots + "\" # " + dots + "\n" + smallest, "f"));
}

TEST(StyleFile, WithEndlessMistakesListsTheFirstThousand) {
    std::string text = smallest;
    for (int i = 0; i < 5000; ++i)
        text += "unknown" + std::to_string(i) + " = 1\n";
    const auto style = parseStyle(text, "f");
    ASSERT_FALSE(style);
    EXPECT_EQ(style.problems().size(), 1001U);
    EXPECT_THAT(style.problems().back().message, HasSubstr("and 4000 more problems"));
}

}  // namespace
}  // namespace kushi
