// SPDX-License-Identifier: Apache-2.0
#include "style/document.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

namespace kushi {
namespace {

std::string_view textOf(const Document& document, const Node& node) {
    return document.text.substr(node.begin, node.end - node.begin);
}

const Node& at(const Node& table, std::string_view key) {
    return table.find(key)->value;
}

TEST(LineMap, CountsCharactersNotBytes) {
    const std::string text = "ab\n\xE6\xAB\x9B = 1\r\nx";  // a comb, three bytes
    const LineMap lines(text);
    EXPECT_EQ(lines.position(0), (Position{1, 1}));
    EXPECT_EQ(lines.position(3), (Position{2, 1}));
    EXPECT_EQ(lines.position(6), (Position{2, 2}));
    EXPECT_EQ(lines.position(11), (Position{2, 7}));
    EXPECT_EQ(lines.position(12), (Position{3, 1}));
    EXPECT_EQ(lines.position(13), (Position{3, 2}));
    EXPECT_EQ(lines.offset({2, 2}), 6U);
    EXPECT_EQ(lines.offset({3, 1}), 12U);
    EXPECT_EQ(lines.offset({9, 1}), text.size());
}

TEST(LineMap, GoesBothWaysOnLongLinesOfMixedCharacters) {
    std::string text = "\xEF\xBB\xBF";  // byte order mark, not counted
    std::vector<std::size_t> starts;
    std::vector<Position> positions;
    int line = 1;
    int column = 1;
    for (int i = 0; i < 3000; ++i) {
        starts.push_back(text.size());
        positions.push_back({line, column++});
        const bool isNewline = i % 1300 == 1299;
        text += isNewline ? "\n" : i % 3 == 0 ? "\xF0\x9F\x92\x87" : i % 3 == 1 ? "a" : "\xC3\xA9";
        if (isNewline) {
            ++line;
            column = 1;
        }
    }
    const LineMap lines(text);
    for (std::size_t i = 0; i < starts.size(); ++i) {
        ASSERT_EQ(lines.position(starts[i]), positions[i]) << i;
        ASSERT_EQ(lines.offset(positions[i]), starts[i]) << i;
    }
}

TEST(Document, KnowsTheExtentOfEveryKindOfValue) {
    const std::string text =
        "s = \"a \\\" # b\" # \xE6\xAB\x9B\n"
        "m = '''x\n'y''' #\n"
        "i = 1_000\t\n"
        "\xEF\xBD\xB1 = 0\n"
        "f =-1e-9# c\n"
        "d = 1979-05-27T07:32:00Z\n"
        "a = [ 1, # one\n  [2],\n]  # end\n"
        "t = { x = { y = 1 }, z = inf }\n"
        "l = true";
    // A bare key must be ASCII; give that line a quoted one.
    std::string quoted = text;
    quoted.replace(quoted.find("\xEF\xBD\xB1"), 3, "\"\xEF\xBD\xB1\"");
    const auto document = parseDocument(quoted, "f");
    ASSERT_TRUE(document) << toString(document.problems()[0]);
    const Node& root = document->root;
    EXPECT_EQ(textOf(*document, at(root, "s")), "\"a \\\" # b\"");
    EXPECT_EQ(at(root, "s").string(), "a \" # b");
    EXPECT_EQ(textOf(*document, at(root, "m")), "'''x\n'y'''");
    EXPECT_EQ(textOf(*document, at(root, "i")), "1_000");
    EXPECT_EQ(at(root, "i").integer(), 1000);
    EXPECT_EQ(textOf(*document, at(root, "f")), "-1e-9");
    EXPECT_EQ(at(root, "f").number(), -1e-9);
    EXPECT_EQ(textOf(*document, at(root, "d")), "1979-05-27T07:32:00Z");
    EXPECT_EQ(textOf(*document, at(root, "a")), "[ 1, # one\n  [2],\n]");
    EXPECT_EQ(textOf(*document, at(root, "a").items[1]), "[2]");
    EXPECT_EQ(textOf(*document, at(root, "t")), "{ x = { y = 1 }, z = inf }");
    EXPECT_EQ(textOf(*document, at(at(root, "t"), "x")), "{ y = 1 }");
    EXPECT_EQ(textOf(*document, at(at(root, "t"), "z")), "inf");
    EXPECT_EQ(textOf(*document, at(root, "l")), "true");
}

TEST(Document, KnowsHowTablesCameToBe) {
    const auto document = parseDocument(
        "dotted.key = 1\n"
        "inline = { x.y = 1 }\n"
        "[implicit.header]\n"
        "[[several]]\n[several.within]\n[[several]]\n"
        "[late.first]\n[late]\n",
        "f");
    ASSERT_TRUE(document) << toString(document.problems()[0]);
    const Node& root = document->root;
    EXPECT_EQ(root.form, Form::Header);
    EXPECT_EQ(at(root, "dotted").form, Form::Dotted);
    EXPECT_EQ(at(root, "inline").form, Form::Value);
    EXPECT_EQ(at(at(root, "inline"), "x").form, Form::Dotted);
    EXPECT_EQ(at(root, "implicit").form, Form::Implicit);
    EXPECT_EQ(at(at(root, "implicit"), "header").form, Form::Header);
    EXPECT_EQ(at(root, "several").form, Form::Header);
    ASSERT_EQ(at(root, "several").items.size(), 2U);
    EXPECT_EQ(at(root, "several").items[0].form, Form::Header);
    EXPECT_EQ(document->lines.position(at(root, "several").items[1].begin), (Position{6, 1}));
    EXPECT_EQ(at(root, "late").form, Form::Header);
    EXPECT_EQ(document->lines.position(at(root, "late").begin), (Position{8, 1}));
}

TEST(Document, KeepsTheOrderOfTheText) {
    const auto document = parseDocument("z = 1\na = 2\nm = 3\n", "f");
    ASSERT_TRUE(document);
    std::vector<std::string> keys;
    for (const Entry& entry : document->root.entries)
        keys.push_back(entry.key);
    EXPECT_THAT(keys, testing::ElementsAre("z", "a", "m"));
}

}  // namespace
}  // namespace kushi
