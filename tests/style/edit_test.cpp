// SPDX-License-Identifier: Apache-2.0
#include <kushi/style.h>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

namespace kushi {
namespace {

using testing::HasSubstr;

// Comments, odd spacing, all spellings of numbers, characters of several bytes, values over several
// lines: what an edit must leave alone.
const std::string nasty =
    "# 櫛: \"kushi = 2\" # é\n"
    "\n"
    "kushi=1#version\n"
    "  name\t=  \"a \\\"bob\\\" # 髪 = 1\"   # é name = \"x\"\n"
    "seed = 1_000\n"
    "gravity = [ 0, # x\n"
    "  -1e0, # é y\n"
    "  0x0 ]  # z\n"
    "\n"
    "[ solver ]   # how well\n"
    "\tsegments = 0x10   # sixteen\n"
    "# end of solver\n"
    "\n"
    "[[part]]\n"
    "name='''tail'''\n"
    "[part.scalp] # 髪\n"
    "ellipsoid = { center = [0, 0.50, 0], \"semi_axes\" = [1_0.5, 12.5, 8.5] } # é\n"
    "count = +50_000\n"
    "regions = [ { theta = [0, 1e2] }, # é\n"
    "            { phi = [-180, 180], theta = [0, 45] } ]\n"
    "[part.hair]\n"
    "length = 25.0\n"
    "flexural_rigidity = 7.80e-9 # \"e-9\"\n"
    "[[part.force]]\n"
    "direction = \"z\" # é\n"
    "within.y = [3.5, inf]\n"
    "[[part.force]] # second\n"
    "  magnitude = -0.50 # é\n"
    "  direction = [0, 1, 0]\n"
    "[part.force.falloff]\n"
    "[[part.cut]]\n"
    "keep = [[-4, 2.0], # é\n"
    " [8, 6.0]]\n"
    "[[part]]\n"
    "scalp.ellipsoid.semi_axes = [1, 1, 1]\n"
    "scalp.count = 5\n"
    "hair = {}\n"
    "hair_is_missing = 1\n";

std::string replaced(std::string text, const std::string& from, const std::string& to) {
    const std::size_t at = text.find(from);
    EXPECT_NE(at, std::string::npos) << from;
    EXPECT_EQ(text.find(from, at + 1), std::string::npos) << from << " is there twice";
    return at == std::string::npos ? text : text.replace(at, from.size(), to);
}

std::string withCrLf(const std::string& text) {
    std::string result;
    for (const char c : text)
        result += c == '\n' ? std::string("\r\n") : std::string(1, c);
    return result;
}

// The document without its last lines, which are wrong on purpose.
std::string base() {
    return replaced(replaced(nasty, "hair_is_missing = 1\n", ""), "hair = {}",
                    "hair = {length = 3}");
}

struct Edit {
    std::string key;
    StyleValue value;
    std::string from, to;  // what must change in the text, and nothing else
};

std::ostream& operator<<(std::ostream& out, const Edit& edit) {
    return out << edit.key;
}

class StyleEdit : public testing::TestWithParam<Edit> {};

TEST_P(StyleEdit, ChangesTheValueAndNothingElse) {
    const auto& [key, value, from, to] = GetParam();
    const auto changed = withValue(base(), key, value);
    ASSERT_TRUE(changed) << toString(changed.problems()[0]);
    EXPECT_EQ(*changed, replaced(base(), from, to));
}

TEST_P(StyleEdit, KeepsWindowsLineEnds) {
    const auto& [key, value, from, to] = GetParam();
    const auto changed = withValue(withCrLf(base()), key, value);
    ASSERT_TRUE(changed) << toString(changed.problems()[0]);
    EXPECT_EQ(*changed, withCrLf(replaced(base(), from, to)));
}

const Edit replacements[] = {
    {"name", std::string("a\\b \"c\" é"), "\"a \\\"bob\\\" # 髪 = 1\"", "\"a\\\\b \\\"c\\\" é\""},
    {"seed", std::int64_t{7}, "1_000", "7"},
    {"gravity", std::vector<double>{0, -0.5, 0}, "[ 0, # x\n  -1e0, # é y\n  0x0 ]",
     "[0.0, -0.5, 0.0]"},
    {"gravity[1]", -2.0, "-1e0", "-2.0"},
    {"solver.segments", std::int64_t{32}, "0x10", "32"},
    {"part[0].name", std::string("rest"), "'''tail'''", "\"rest\""},
    {"part[0].scalp.ellipsoid.center", std::vector<double>{1, 2, 3}, "[0, 0.50, 0]",
     "[1.0, 2.0, 3.0]"},
    {"part[0].scalp.ellipsoid.semi_axes[0]", 10.25, "1_0.5", "10.25"},
    {"part[0].scalp.count", std::int64_t{100}, "+50_000", "100"},
    {"part[0].scalp.regions[0].theta", std::vector<double>{0, 90}, "[0, 1e2]", "[0.0, 90.0]"},
    {"part[0].scalp.regions[1].phi", std::vector<double>{90, 270}, "[-180, 180]", "[90.0, 270.0]"},
    {"part[0].hair.length", 0.1 + 0.2, "25.0", "0.30000000000000004"},
    {"part[0].hair.flexural_rigidity", 1e-9, "7.80e-9", "1.0e-09"},
    {"part[0].force[0].direction", std::string("in"), "\"z\"", "\"in\""},
    {"part[0].force[0].within.y", std::vector<double>{-std::numeric_limits<double>::infinity(), 1},
     "[3.5, inf]", "[-inf, 1.0]"},
    {"part[0].force[1].magnitude", 1.0, "-0.50", "1.0"},
    {"part[0].cut[0].keep[1][1]", 7.5, "6.0", "7.5"},
    {"part[1].scalp.count", std::int64_t{9}, "scalp.count = 5", "scalp.count = 9"},
    {"part[1].hair.length", 4.0, "{length = 3}", "{length = 4.0}"},
};
INSTANTIATE_TEST_SUITE_P(Replacing, StyleEdit, testing::ValuesIn(replacements));

const Edit additions[] = {
    {"solver.avoidance_steps", std::int64_t{8}, "# sixteen\n",
     "# sixteen\n\tavoidance_steps = 8\n"},
    {"part[0].scalp.jitter", 0.25, "theta = [0, 45] } ]\n", "theta = [0, 45] } ]\njitter = 0.25\n"},
    {"part[0].scalp.ellipsoid.rotate_z", 20.0, "[1_0.5, 12.5, 8.5] }",
     "[1_0.5, 12.5, 8.5], rotate_z = 20.0 }"},
    {"part[0].scalp.regions[0].phi", std::vector<double>{0, 90}, "[0, 1e2] }",
     "[0, 1e2], phi = [0.0, 90.0] }"},
    {"part[0].hair.stiffness", 2.0, "# \"e-9\"\n", "# \"e-9\"\nstiffness = 2.0\n"},
    {"part[0].force[0].magnitude", 0.5, "within.y = [3.5, inf]\n",
     "within.y = [3.5, inf]\nmagnitude = 0.5\n"},
    {"part[0].force[0].within.x", std::vector<double>{0, 5}, "within.y = [3.5, inf]\n",
     "within.y = [3.5, inf]\nwithin.x = [0.0, 5.0]\n"},
    {"part[0].force[1].falloff.cm", 1.0, "[part.force.falloff]\n",
     "[part.force.falloff]\ncm = 1.0\n"},
    {"part[0].cut[0].mode", std::string("hide"), " [8, 6.0]]\n", " [8, 6.0]]\nmode = \"hide\"\n"},
    {"part[1].name", std::string("b"), "hair = {length = 3}\n",
     "hair = {length = 3}\nname = \"b\"\n"},
    {"part[1].scalp.ellipsoid.rotate_z", 1.5, "semi_axes = [1, 1, 1]\n",
     "semi_axes = [1, 1, 1]\nscalp.ellipsoid.rotate_z = 1.5\n"},
    {"part[1].scalp.jitter", 0.0, "scalp.count = 5\n", "scalp.count = 5\nscalp.jitter = 0.0\n"},
    {"part[1].hair.stiffness", 3.0, "{length = 3}", "{length = 3, stiffness = 3.0}"},
};
INSTANTIATE_TEST_SUITE_P(Adding, StyleEdit, testing::ValuesIn(additions));

TEST(StyleEdits, RoundTripThroughTheReader) {
    const double awkward[] = {0.1, 1.0 / 3, 123.456789012345678, 299.99999999999994};
    for (const double length : awkward) {
        const auto changed = withValue(base(), "part[0].hair.length", length);
        ASSERT_TRUE(changed);
        EXPECT_EQ(parseStyle(*changed, "f")->parts[0].hair.length, length / 100);
    }
    const auto named = withValue(base(), "name", std::string("tab\t quote\" \\ 櫛\n\x7F"));
    ASSERT_TRUE(named);
    EXPECT_EQ(parseStyle(*named, "f")->name, "tab\t quote\" \\ 櫛\n\x7F");
    const auto seeded = withValue(base(), "seed", std::int64_t{9223372036854775807});
    ASSERT_TRUE(seeded);
    EXPECT_EQ(parseStyle(*seeded, "f")->seed, 9223372036854775807U);
}

TEST(StyleEdits, ReachAGroomAndItsSet) {
    const std::string style =
        "kushi = 1\ngroom = \"a.hair\" # scan\n[solver]\nmethod = \"equilibrium\"\n[hair]\n";
    const auto other = withValue(style, "part[0].groom", std::string("b.ply"));
    ASSERT_TRUE(other) << toString(other.problems()[0]);
    EXPECT_EQ(*other, replaced(style, "\"a.hair\"", "\"b.ply\""));
    const auto softer = withValue(style, "part[0].hair.set", 0.5);
    ASSERT_TRUE(softer) << toString(softer.problems()[0]);
    EXPECT_EQ(*softer, style + "set = 0.5\n");

    const std::string placed = replaced(style, "\"a.hair\"", "{ file = \"a.hair\" }");
    const auto scaled = withValue(placed, "part[0].groom.unit", std::string("mm"));
    ASSERT_TRUE(scaled) << toString(scaled.problems()[0]);
    EXPECT_EQ(*scaled, replaced(placed, "\"a.hair\" }", "\"a.hair\", unit = \"mm\" }"));
    EXPECT_FALSE(withValue(style, "part[0].hair.length", 10.0));
}

TEST(StyleEdits, OfTheSameValueTwiceChangeNothingMore) {
    const auto once = withValue(base(), "part[0].force[0].magnitude", 0.5);
    ASSERT_TRUE(once);
    const auto twice = withValue(*once, "part[0].force[0].magnitude", 0.5);
    ASSERT_TRUE(twice);
    EXPECT_EQ(*twice, *once);
}

const std::string atTop =
    "kushi = 1\n[scalp.ellipsoid]\nsemi_axes = [1, 1, 1]\n"
    "[scalp]\ncount = 5\n[hair]\nlength = 25";

TEST(StyleEdits, ReachTheOnlyPartByBothItsNames) {
    const std::string expected = replaced(atTop, "length = 25", "length = 3.0");
    for (const char* key : {"hair.length", "part[0].hair.length"}) {
        const auto changed = withValue(atTop, key, 3.0);
        ASSERT_TRUE(changed) << toString(changed.problems()[0]);
        EXPECT_EQ(*changed, expected);
    }
    EXPECT_FALSE(withValue(atTop, "part[1].hair.length", 3.0));
    EXPECT_FALSE(withValue(atTop, "part[0].name", std::string("x")));
}

TEST(StyleEdits, AddALineBelowALastLineWithoutEnd) {
    const auto changed = withValue(atTop, "hair.stiffness", 3.0);
    ASSERT_TRUE(changed);
    EXPECT_EQ(*changed, atTop + "\nstiffness = 3.0");
}

TEST(StyleEdits, AddToTheDocumentItself) {
    const auto changed = withValue(atTop, "seed", std::int64_t{3});
    ASSERT_TRUE(changed);
    EXPECT_EQ(*changed, replaced(atTop, "kushi = 1\n", "kushi = 1\nseed = 3\n"));

    const std::string headless = "\xEF\xBB\xBF" + replaced(atTop, "kushi = 1\n", "");
    const auto mended = withValue(headless, "kushi", std::int64_t{1});
    ASSERT_TRUE(mended) << toString(mended.problems()[0]);
    EXPECT_EQ(*mended, "\xEF\xBB\xBFkushi = 1\n" + headless.substr(3));
}

TEST(StyleEdits, FillEmptyInlineTables) {
    for (const char* braces : {"{}", "{ }", "{\t  }"}) {
        const std::string text = atTop + "\n[[force]]\ndirection = 'z'\nfalloff = " + braces + "\n";
        const auto changed = withValue(text, "force[0].falloff.cm", 1.0);
        ASSERT_TRUE(changed) << toString(changed.problems()[0]);
        EXPECT_EQ(*changed, replaced(text, braces, "{ cm = 1.0 }"));
    }
}

TEST(StyleEdits, GiveATableAHeaderWhereOnlyThoseInsideHaveOne) {
    const std::string text =
        "kushi = 1\nhair = { length = 5 }\n# where\n[scalp.ellipsoid]\nsemi_axes = [1, 1, 1]\n";
    const auto changed = withValue(text, "scalp.count", std::int64_t{5});
    ASSERT_TRUE(changed) << toString(changed.problems()[0]);
    EXPECT_EQ(*changed,
              replaced(text, "[scalp.ellipsoid]", "[scalp]\ncount = 5\n\n[scalp.ellipsoid]"));
}

TEST(StyleEdits, MayMendAStyleThatIsNotValid) {
    const auto mended =
        withValue(replaced(base(), "0x10", "0"), "solver.segments", std::int64_t{16});
    ASSERT_TRUE(mended);
    EXPECT_EQ(*mended, replaced(base(), "0x10", "16"));
}

TEST(StyleEdits, ThatCannotBeAreProblems) {
    const auto problemOf = [](std::string_view text, std::string_view key,
                              const StyleValue& value) {
        const auto changed = withValue(text, key, value);
        EXPECT_FALSE(changed.ok()) << key;
        return changed ? std::string() : toString(changed.problems()[0]);
    };
    const std::string text = base();
    EXPECT_THAT(problemOf(text, "part[0].hair.length", 500.0), HasSubstr("length: found 500.0"));
    EXPECT_THAT(problemOf(text, "part[0].hair.length", std::nan("")), HasSubstr("found nan"));
    EXPECT_THAT(problemOf(text, "part[0].hair.length", true), HasSubstr("found true"));
    EXPECT_THAT(problemOf(text, "solver.segments", 24.0), HasSubstr("found 24.0"));
    EXPECT_THAT(problemOf(text, "part[0].hair.lenth", 5.0), HasSubstr("unknown key 'lenth'"));
    EXPECT_THAT(problemOf(text, "part[0].hair", 5.0), HasSubstr("part[0].hair is a table"));
    EXPECT_THAT(problemOf(text, "part", 5.0), HasSubstr("part is a table"));
    EXPECT_THAT(problemOf(text, "part[1].scalp", 5.0), HasSubstr("part[1].scalp is a table"));
    EXPECT_THAT(problemOf(text, "head.mesh", std::string("none")),
                HasSubstr("the style has no head"));
    EXPECT_THAT(problemOf(text, "part[2].name", std::string("x")),
                HasSubstr("the style has no part[2]"));
    EXPECT_THAT(problemOf(text, "gravity[3]", 1.0), HasSubstr("the style has no gravity[3]"));
    EXPECT_THAT(problemOf(text, "seed.x", 1.0), HasSubstr("the style has no seed.x"));
    EXPECT_THAT(problemOf(text, "seed.x.y", 1.0), HasSubstr("the style has no seed.x"));
    EXPECT_THAT(problemOf(text, "", 1.0), HasSubstr("found the key"));
    EXPECT_THAT(problemOf(text, "part[0]..length", 1.0), HasSubstr("found the key"));
    EXPECT_THAT(problemOf(text, "name", std::string("\xFF")), HasSubstr("UTF-8"));
    EXPECT_THAT(problemOf("kushi = ", "kushi", std::int64_t{1}), HasSubstr("the file ends"));
    EXPECT_FALSE(withValue(nasty, "seed", std::int64_t{1}));
}

}  // namespace
}  // namespace kushi
