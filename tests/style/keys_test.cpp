// SPDX-License-Identifier: Apache-2.0
#include "style/keys.h"

#include "style/key_path.h"
#include "style/spelling.h"

#include <array>

#include <gtest/gtest.h>

namespace kushi {
namespace {

constexpr std::array<std::string_view, 4> someKeys = {"length", "length_variation", "density",
                                                      "type"};

TEST(Nearest, FindsOneLetterMissingAddedWrongOrSwapped) {
    EXPECT_EQ(nearest("lenth", someKeys), "length");
    EXPECT_EQ(nearest("lengtth", someKeys), "length");
    EXPECT_EQ(nearest("lemgth", someKeys), "length");
    EXPECT_EQ(nearest("lenght", someKeys), "length");
    EXPECT_EQ(nearest("tpye", someKeys), "type");
}

TEST(Nearest, LeavesAloneWhatResemblesNothing) {
    EXPECT_EQ(nearest("colour", someKeys), "");
    EXPECT_EQ(nearest("ty", someKeys), "");
    EXPECT_EQ(nearest("", someKeys), "");
    EXPECT_EQ(nearest(std::string(1'000'000, 'x'), someKeys), "");
}

TEST(KeyPath, IsNamesAndIndices) {
    const auto path = parseKeyPath("part[0].force[12].magnitude");
    ASSERT_TRUE(path);
    const std::vector<Step> expected = {Step("part"), Step(std::size_t{0}), Step("force"),
                                        Step(std::size_t{12}), Step("magnitude")};
    EXPECT_EQ(*path, expected);
    EXPECT_EQ(toString(*path), "part[0].force[12].magnitude");
}

TEST(KeyPath, RefusesWhatIsNoPath) {
    for (const char* text : {"", ".", "a.", ".a", "a..b", "a[", "a[]", "a[1", "a[-1]", "a[x]",
                             "a[1]b", "[0]", "a b", "a[99999999999999999999999]", "\"a\""}) {
        EXPECT_FALSE(parseKeyPath(text)) << text;
    }
}

TEST(Spelling, FloatsAreShortAndHaveADecimalPoint) {
    EXPECT_EQ(spell(1.0), "1.0");
    EXPECT_EQ(spell(-0.1), "-0.1");
    EXPECT_EQ(spell(1e-9), "1.0e-09");
    EXPECT_EQ(spell(7.8e-9), "7.8e-09");
    EXPECT_EQ(spell(1e300), "1.0e+300");
    EXPECT_EQ(spell(0.1 + 0.2), "0.30000000000000004");
    EXPECT_EQ(spell(std::vector<double>{0, -1, 0.5}), "[0.0, -1.0, 0.5]");
    EXPECT_EQ(spell(std::vector<double>{}), "[]");
}

TEST(Spelling, StringsAreEscaped) {
    EXPECT_EQ(spell(std::string("a \"b\" \\ c\n\t\x01")), R"("a \"b\" \\ c\n\t\u0001")");
    EXPECT_EQ(spell(std::string("\xC3\xA9")), "\"\xC3\xA9\"");
}

TEST(Spelling, NumbersForPeopleHaveSixDigits) {
    EXPECT_EQ(plainNumber(0.1), "0.1");
    EXPECT_EQ(plainNumber(300), "300");
    EXPECT_EQ(plainNumber(1e-12), "1e-12");
    EXPECT_EQ(plainNumber(0.3 * 0.1), "0.03");
}

}  // namespace
}  // namespace kushi
