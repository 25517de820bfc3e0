// SPDX-License-Identifier: Apache-2.0
#include <kushi/style.h>

#include <algorithm>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

namespace kushi {
namespace {

/// A style with '@' before each place that must be complained about, and what must be said there.
struct Malformed {
    std::string text;
    std::vector<std::string> messages;
};

std::ostream& operator<<(std::ostream& out, const Malformed& malformed) {
    return out << malformed.text;
}

struct Place {
    int line = 1, column = 1;
};

std::vector<Place> takeMarks(std::string& text) {
    std::vector<Place> places;
    std::string rest;
    Place place;
    for (const char c : text) {
        if (c == '@') {
            places.push_back(place);
            continue;
        }
        rest += c;
        const bool continues = (static_cast<unsigned char>(c) & 0xC0U) == 0x80U;
        place.column += continues ? 0 : 1;
        if (c == '\n') place = {place.line + 1, 1};
    }
    text = rest;
    return places;
}

const std::string scalpTable = "[scalp]\nellipsoid = { semi_axes = [10, 12, 8] }\nspacing = 0.5\n";
const std::string hairTable = "[hair]\nlength = 25\n";

// Styles that are right but for some lines.
std::string atTop(const std::string& lines) {
    return "kushi = 1\n" + lines + "\n" + scalpTable + hairTable;
}
std::string withTables(const std::string& lines) {
    return atTop("") + lines + "\n";
}
std::string inScalp(const std::string& lines) {
    return "kushi = 1\n[scalp]\nellipsoid = { semi_axes = [10, 12, 8] }\n" + lines + "\n" +
           hairTable;
}
std::string inHair(const std::string& lines) {
    return atTop("") + lines + "\n";
}
std::string inForce(const std::string& lines) {
    return withTables("[[force]]\ndirection = \"z\"\n" + lines);
}
std::string inCut(const std::string& lines) {
    return withTables("[[cut]]\n" + lines);
}
std::string parts(const std::string& first, const std::string& second = "[[part]]") {
    const std::string body =
        "[part.scalp]\nellipsoid = { semi_axes = [10, 12, 8] }\ncount = 5\n"
        "[part.hair]\nlength = 25\n";
    return "kushi = 1\n[[part]]\n" + first + "\n" + body + second + "\n" + body;
}

class MalformedStyle : public testing::TestWithParam<Malformed> {};

TEST_P(MalformedStyle, IsRefusedWithItsMessageAtItsPlace) {
    std::string text = GetParam().text;
    const std::vector<Place> places = takeMarks(text);
    ASSERT_EQ(places.size(), GetParam().messages.size());
    const auto style = parseStyle(text, "bad.toml");
    ASSERT_FALSE(style);
    const std::vector<Problem>& problems = style.problems();
    for (const Problem& problem : problems) {
        EXPECT_EQ(problem.file, "bad.toml");
        EXPECT_FALSE(problem.system);
        EXPECT_FALSE(problem.message.ends_with('.'));
    }
    std::string listing;
    for (const Problem& problem : problems)
        listing += toString(problem) + '\n';
    ASSERT_EQ(problems.size(), places.size()) << listing;
    for (std::size_t i = 0; i < places.size(); ++i) {
        EXPECT_EQ(problems[i].line, places[i].line) << listing;
        EXPECT_EQ(problems[i].column, places[i].column) << listing;
        EXPECT_THAT(problems[i].message, testing::HasSubstr(GetParam().messages[i]));
    }
}

const Malformed syntax[] = {
    {"kushi = 1\nname = @bob\n", {"found bob without quotes, expected a value such as \"bob\""}},
    {"[hair]\ntype = @fine\n", {"found fine without quotes"}},
    {"kushi = 1\nseed = 2@,5\n", {"expected a comment or whitespace, saw ','"}},
    {"kushi = 1\nseed =@\n", {"expected value, saw '\\n'"}},
    {"kushi = 1\nname = \"bob@\n", {"(in a string)"}},
    {"kushi = 1\nname = \"bob@", {"the file ends within a string"}},
    {"kushi = 1\n@kushi = 1\n", {"'kushi' is given twice"}},
    {"# \xE6\xAB\x9B\nhair = { length = 1, @length = 2 }\n", {"'length' is given twice"}},
    {"[hair]\n[scalp]\n@[hair]\n", {"[hair] is given twice"}},
    {"[[part]]\n@[part]\n", {"cannot redefine existing array 'part' as table"}},
    {"gravity = [0 @-1 0]\n", {"expected comma or closing ']', saw '-'"}},
    {"gravity = [@}]\n", {"could not determine value type"}},
    {"# caf\xC3\xA9\nname = caf@\xC3\xA9\n",
     {"found '\xC3\xA9', expected no such character outside of strings and comments"}},
    {"seed = 1@\xC2\xA0# no-break space\n", {"found '\xC2\xA0'"}},
    {"seed = 5.\"@\xE3\x81\x82\"\n", {"found '\xE3\x81\x82'"}},
    {"name = \"\"\"\\ \n @\xC3\xA9\"\"\"\n", {"found '\xC3\xA9'"}},
    {"[hair@\nlength = 25\n", {"expected ']', saw '\\n'"}},
    {"@= 1\n", {"expected keys, tables, whitespace or comments"}},
    {"seed = 010@\n", {"leading zeroes are prohibited"}},
    {"name = \"caf\\@q\"\n", {"unknown escape sequence"}},
    {"hair = { length = 25,@\n}\n", {"inline table"}},
};
INSTANTIATE_TEST_SUITE_P(Syntax, MalformedStyle, testing::ValuesIn(syntax));

const Malformed keys[] = {
    {atTop("@sead = 5"), {"unknown key 'sead' in the style; did you mean 'seed'?"}},
    {atTop("@tint = 5"), {"unknown key 'tint' in the style; expected 'kushi', 'name', 'seed'"}},
    {atTop("@length = 5"), {"'length' in the style; it belongs in [hair]"}},
    {withTables("[@sovler]\n"), {"did you mean 'solver'?"}},
    {withTables("[head]\n@seed = 5"), {"it belongs at the top, before any [table]"}},
    {withTables("[head]\n@mash = \"none\""), {"in [head]; did you mean 'mesh'?"}},
    {withTables("[solver]\n@segment = 5"), {"in [solver]; did you mean 'segments'?"}},
    {parts("@hairs = 1"), {"in [[part]]; did you mean 'hair'?"}},
    {parts("@length = 1"), {"it belongs in [part.hair]"}},
    {"kushi = 1\n" + scalpTable + "[hair]\n@lenght = 25\n", {"did you mean 'length'?"}},
    {"kushi = 1\n[scalp]\nellipsoid = { semi_axes = [10, 12, 8] }\n@spaceing = 1\n" + hairTable,
     {"did you mean 'spacing'?"}},
    {"kushi = 1\n[scalp]\nellipsoid = { @semi_axis = [10, 12, 8] }\ncount = 1\n" + hairTable,
     {"unknown key 'semi_axis' in ellipsoid; did you mean 'semi_axes'?"}},
    {inScalp("count = 1\nregions = [{ @tehta = [0, 1] }]"), {"in regions; did you mean 'theta'?"}},
    {inForce("roots = { @rho = [0, 1] }"), {"in roots; expected 'where', 'theta' or 'phi'"}},
    {inForce("within = { y = [0, 1], @theta = [0, 1] }"), {"in within; it belongs in regions"}},
    {inForce("falloff = { @mm = 1 }"), {"in falloff"}},
    {inForce("@magnitud = 1"), {"in [[force]]; did you mean 'magnitude'?"}},
    {inCut("below = 1\n@modes = \"hide\""), {"in [[cut]]; did you mean 'mode'?"}},
    {inHair("@\"dia meter\" = 1"), {"unknown key 'dia meter' in [hair]; did you mean 'diameter'?"}},
    {atTop("@" + std::string(100, 'k') + " = 1"), {"key '" + std::string(40, 'k') + "...'"}},
};
INSTANTIATE_TEST_SUITE_P(UnknownKeys, MalformedStyle, testing::ValuesIn(keys));

const Malformed missing[] = {
    {"@name = \"bob\"\n" + scalpTable + hairTable, {"no 'kushi', expected the format version"}},
    {"@kushi = 1\n", {"the style has no hair, expected [[part]] with [part.scalp]"}},
    {"@@", {"no 'kushi'", "the style has no hair"}},
    {"@kushi = 1\n" + scalpTable, {"the style has no 'hair', expected [hair]"}},
    {"kushi = 1\n@[[part]]\n[part.hair]\nlength = 25\n",
     {"[[part]] has neither 'scalp' nor 'groom', expected one of them, as in [part.scalp]"}},
    {"kushi = 1\n@[[part]]\n[part.scalp]\nellipsoid = { semi_axes = [10, 12, 8] }\ncount = 1\n",
     {"[[part]] has no 'hair', expected [part.hair]"}},
    {"kushi = 1\n" + scalpTable + "  @[hair]\ntype = \"fine\"\n",
     {"[hair] has no 'length', expected a number of cm"}},
    {"kushi = 1\n@[scalp]\ncount = 1\n" + hairTable, {"[scalp] has no 'ellipsoid'"}},
    {"kushi = 1\n[scalp]\nellipsoid = @{ rotate_z = 2 }\ncount = 1\n" + hairTable,
     {"ellipsoid has no 'semi_axes'"}},
    {"kushi = 1\n@[scalp]\nellipsoid = { semi_axes = [10, 12, 8] }\n" + hairTable,
     {"[scalp] has neither 'spacing' nor 'count', expected one of them"}},
    {withTables("@[[force]]\nmagnitude = 1"), {"[[force]] has no 'direction'"}},
    {withTables("@[[cut]]\nmode = \"hide\""), {"[[cut]] has neither 'below' nor 'keep'"}},
    {"kushi = 1\npart = @[]\n", {"part: found an empty array, expected at least one [[part]]"}},
    {inScalp("count = 1\nregions = @[]"), {"regions: found an empty array"}},
    {inScalp("count = 1\n@spacing = 1"), {"found both 'spacing' and 'count'"}},
    {inCut("keep = [[1, 2]]\n@below = 1"), {"found both 'below' and 'keep'"}},
    {inCut("below = 1\nroots = { @phi = [0, 9], where = \"nape\", @theta = [0, 9] }"),
     {"found 'phi' beside 'where', expected one of them", "found 'theta' beside 'where'"}},
};
INSTANTIATE_TEST_SUITE_P(MissingKeys, MalformedStyle, testing::ValuesIn(missing));

const Malformed types[] = {
    {"kushi = @\"1\"\n" + scalpTable + hairTable, {"kushi: found the string \"1\", expected 1"}},
    {"kushi = @1.0\n" + scalpTable + hairTable, {"kushi: found 1.0, expected 1"}},
    {"kushi = @0\n" + scalpTable + hairTable, {"kushi: found 0, expected 1"}},
    {"kushi = @2\nsomething = \"new\"\n[hair]\nlength = \"any\"\n",
     {"written for Kushi format 2; this program reads format 1: get a newer Kushi"}},
    {atTop("name = @5"), {"name: found 5, expected a string"}},
    {atTop("seed = @1.5"), {"seed: found 1.5, expected a whole number from 0"}},
    {atTop("seed = @true"), {"seed: found true"}},
    {atTop("gravity = @[0, -1]"), {"gravity: found an array of 2, expected an array of 3"}},
    {atTop("gravity = @-1"), {"gravity: found -1, expected an array of 3"}},
    {atTop("gravity = [0, @\"down\", 0]"), {"gravity: found the string \"down\", expected a num"}},
    {atTop("head = @\"none\""), {"head: found the string \"none\", expected the table [head]"}},
    {atTop("solver = @[1]"), {"solver: found an array of 1, expected the table [solver]"}},
    {withTables("[solver]\nsegments = @24.0"), {"segments: found 24.0, expected a whole number"}},
    {withTables("[solver]\nmethod = @1"), {"method: found 1, expected \"cantilever\""}},
    {"kushi = 1\n@[part]\n[part.hair]\nlength = 1\n",
     {"part: found a table, expected [[part]], one for each"}},
    {"kushi = 1\npart = [@5]\n", {"part: found 5, expected a table"}},
    {withTables("@[force]\ndirection = \"z\""), {"force: found a table, expected [[force]], one"}},
    {parts("", "@[part.cut]\nbelow = 1\n[[part]]"), {"cut: found a table, expected [[part.cut]]"}},
    {"kushi = 1\n" + scalpTable + "@[[hair]]\nlength = 25\n",
     {"hair: found an array of 1, expected the table [hair]"}},
    {inHair("diameter = @\"75 um\""), {"numbers stand without quotes and units"}},
    {inHair("diameter = @[75]"), {"diameter: found an array of 1, expected a number"}},
    {inHair("diameter = @1979-05-27"), {"diameter: found the date 1979-05-27"}},
    {inHair("stiffness = @{ bending = 1 }"), {"stiffness: found a table, expected a number"}},
    {inScalp("count = @50_000.0"), {"count: found 50_000.0, expected a whole number from 1"}},
    {inScalp("count = 1\nregions = @{ theta = [0, 1] }"),
     {"regions: found a table, expected an array of tables"}},
    {inScalp("count = 1\nregions = [{ theta = @5 }, @5]"),
     {"theta: found 5, expected a range, [low, high]", "regions: found 5, expected a table"}},
    {inForce("roots = @[0, 90]"), {"roots: found an array of 2, expected a table"}},
    {inForce("within = { y = @[1, 2, 3] }"), {"y: found an array of 3, expected a range"}},
    {withTables("[[force]]\ndirection = @5"), {"direction: found 5, expected a name"}},
    {withTables("[[force]]\ndirection = @[0, 1]"), {"direction: found an array of 2"}},
    {inCut("keep = @5"), {"keep: found 5, expected pairs"}},
    {inForce("roots = { where = @[\"left\", \"right\"] }"),
     {"where: found an array of 2, expected \"scalp\", \"crown\""}},
    {inHair("color = @5"), {"color: found 5, expected a name as in \"brown\", sRGB components"}},
    {inHair("color = @[0.5, 0.5]"), {"color: found an array of 2, expected an array of 3"}},
    {inHair("color = [@\"red\", 0, 0]"), {"color: found the string \"red\", expected a number"}},
    {inHair("variation = @\"some\""), {"variation: found the string \"some\""}},
    {inCut("keep = [[1, 2], @[3]]"), {"keep: found an array of 1, expected a pair"}},
};
INSTANTIATE_TEST_SUITE_P(Types, MalformedStyle, testing::ValuesIn(types));

const Malformed ranges[] = {
    {atTop("seed = @-1"), {"seed: found -1"}},
    {atTop("gravity = [0, @-101, @inf]"), {"gravity: found -101", "gravity: found inf"}},
    {withTables("[solver]\nsegments = @0\navoidance_steps = @17"),
     {"from 1 to 256", "from 1 to 16"}},
    {inScalp("spacing = @0.001"), {"expected a number from 0.01 to 10 cm"}},
    {inScalp("spacing = @13"),
     {"spacing: found 13, expected a number from 0.01 to 10 cm; 13 mm "
      "would be 1.3"}},
    {inScalp("count = @5_000_001"), {"found 5_000_001, expected a whole number from 1 to 5000000"}},
    {inScalp("count = 1\njitter = @50"), {"50 % would be 0.5"}},
    {inScalp("count = 1\nregions = [{ theta = [0, @181] }]"), {"from 0 to 180 degrees"}},
    {inScalp("count = 1\nregions = [{ theta = @[90, 90] }]"),
     {"theta: found a range from 90 to 90, expected the lower end first"}},
    {inScalp("count = 1\nregions = [{ phi = @[-100, 270] }]"),
     {"phi: found a range that spans 370 degrees"}},
    {inScalp("count = 1\nregions = [{ phi = [@-400, 0], theta = [0, @inf] }]"),
     {"from -360 to 360 degrees", "theta: found inf"}},
    {"kushi = 1\n[scalp]\nellipsoid = { center = [0, @nan, 0], semi_axes = [@0, 1, @-1], rotate_z "
     "= @361 }\ncount = 1\n" +
         hairTable,
     {"center: found nan", "semi_axes: found 0, expected a number from 0.5 to 100 cm",
      "semi_axes: found -1", "rotate_z: found 361"}},
    {"kushi = 1\n" + scalpTable + "[hair]\nlength = @500\n",
     {"length: found 500, expected a number from 0.1 to 300 cm; 500 mm would be 50"}},
    {"kushi = 1\n" + scalpTable + "[hair]\nlength = @0\n", {"length: found 0"}},
    {"kushi = 1\n" + scalpTable + "[hair]\nlength = @nan\n", {"length: found nan"}},
    {inHair("length_variation = @5"), {"5 % would be 0.05"}},
    {inHair("youngs_modulus = @3.9e9"), {"3.9e9 Pa would be 3.9"}},
    {inHair("youngs_modulus = @3900"), {"3900 MPa would be 3.9"}},
    {inHair("diameter = @0.075"),
     {"found 0.075, expected a number from 10 to 300 micrometres; 0.075 mm would be 75"}},
    {inHair("density = @1320"), {"1320 kg/m3 would be 1.32"}},
    {inHair("flexural_rigidity = @0"), {"from 1e-12 to 1 N m2"}},
    {inHair("stiffness = @-1"), {"from 0.001 to 1000"}},
    {inHair("type = @\"thick\""), {R"(expected "fine", "medium" or "coarse")"}},
    {inHair("type = @\"corse\""), {"did you mean \"coarse\"?"}},
    {inHair("growth = @\"radical\""), {"did you mean \"radial\"?"}},
    {withTables("[head]\nmesh = @\"maniquin\""), {"did you mean \"mannequin\"?"}},
    {withTables("[[force]]\ndirection = @\"sideways\""), {R"(expected "x", "y", "z", "r")"}},
    {withTables("[[force]]\ndirection = @[0, 0.0, 0]"), {"found a zero vector"}},
    {withTables("[[force]]\ndirection = [0, @inf, 0]"), {"direction: found inf"}},
    {inForce("magnitude = @1001"), {"from -1000 to 1000 times the hair's own weight"}},
    {inForce("within = { y = @[inf, 0] }"), {"y: found a range from inf to 0"}},
    {inForce("within = { y = [@nan, inf] }"), {"y: found nan"}},
    {inForce("falloff = { degrees = @-1, cm = @101 }"), {"degrees: found -1", "cm: found 101"}},
    {inHair("color = [0, 0.5, @1.5]\nvariation = @-0.1"),
     {"color: found 1.5, expected a number from 0 to 1", "variation: found -0.1"}},
    {inHair("color = [@120, 1, @nan]"), {"120 of 255 would be 0.470588", "color: found nan"}},
    {inHair("variation = @15"), {"15 % would be 0.15"}},
    {inHair("color = @\"blonde\""), {"did you mean \"blond\"?"}},
    {inHair("color = @\"mauve\""), {R"(expected "black", "dark brown", "brown")"}},
    {inForce("roots = { where = @\"frige\" }"), {"did you mean \"fringe\"?"}},
    {inScalp("count = 1\nregions = [{ where = @\"beard\" }]"),
     {R"(where: found the string "beard", expected "scalp", "crown", "top")"}},
    {inForce("within = { y = @[\"brows\", \"chin\"] }"),
     {R"(y: found a range from "brows" to "chin", expected the lower end first)"}},
    {inForce("within = { y = @[\"brows\", 2.1] }"), {"y: found a range from \"brows\" to 2.1"}},
    {inForce("within = { y = [@\"brow\", inf] }"), {"did you mean \"brows\"?"}},
    {inForce("within = { x = [@\"nose\", inf] }"),
     {"x: found the string \"nose\", expected a num"}},
    {inCut("below = @\"collar\""),
     {R"(below: found the string "collar", expected a number from -1000 to 1000 cm or a landmark of )"
      R"(the head: "crown", "hairline", "brows", "eyes", "ears", "nose", "lips", "nape", "chin" or )"
      R"("shoulders")"}},
    {inCut("below = @\"4 cm\""), {"numbers stand without quotes and units"}},
    {inCut("keep = [[\"nape\", 2], [@\"lips\", 2]]"), {"expected heights in ascending order"}},
    {inCut("keep = [[\"nape\", @\"lips\"]]"), {"keep: found the string \"lips\", expected a num"}},
    {inCut("below = @inf"), {"below: found inf"}},
    {inCut("keep = @[]"), {"keep: found an empty array"}},
    {inCut("keep = [[3, 2], [@3, 2]]"), {"keep: found 3, expected heights in ascending order"}},
    {inCut("keep = [[3, @-2]]"), {"from 0 to 300 cm"}},
    {inCut("below = 1\nmode = @\"settel\""), {"did you mean \"settle\"?"}},
    {parts("name = @\"\""), {"name: found an empty name"}},
    {parts("name = \"a\"", "[[part]]\nname = @\"a\""), {"found a second part called \"a\""}},
    {parts("name = \"hair 2\"", "@[[part]]"), {"found a second part called \"hair 2\""}},
    {parts("") + "@[hair]\nlength = 25\n@[[cut]]\nbelow = 1\n",
     {"'hair' stands at the top, but the style has [[part]]; it belongs in one of the parts, as "
      "part.hair",
      "'cut' stands at the top"}},
};
INSTANTIATE_TEST_SUITE_P(Ranges, MalformedStyle, testing::ValuesIn(ranges));

std::string inHead(const std::string& lines) {
    return withTables("[head]\nmesh = \"me.glb\"\n" + lines);
}

const Malformed heads[] = {
    {withTables("[head]\nmesh = @\"heads/me.fbx\""),
     {R"(mesh: found the string "heads/me.fbx", expected "mannequin", "none" or a file that ends )"
      "in .obj, .ply, .stl, .gltf or .glb"}},
    {withTables("[head]\nmesh = @\"head\""), {R"(expected "mannequin" or "none")"}},
    {withTables("[head]\nmesh = @5"), {"mesh: found 5"}},
    {withTables("[head]\n@brows = 4"), {"unknown key 'brows' in [head]; it belongs in landmarks"}},
    {withTables("[head]\n@unit = \"mm\"\nmesh = \"none\"\n@offset = [0, 0, 0]"),
     {"'unit' places a mesh from a file, and [head] names none", "'offset' places a mesh"}},
    {inHead("unit = @\"ft\""), {R"(expected "m", "cm", "mm" or "in")"}},
    {inHead("unit = @0"), {"unit: found 0, expected a number from 0.0001 to 10000 cm"}},
    {inHead("unit = @true"), {R"(unit: found true, expected "m", "cm", "mm", "in" or a number)"}},
    {inHead("up = @\"up\""), {R"(up: found the string "up", expected "x", "y", "z", "-x")"}},
    {inHead("up = @\"z\""), {"up and front lie along the same axis of the file"}},
    {inHead("front = @\"-y\""), {"up and front lie along the same axis of the file"}},
    {inHead("front = \"-x\"\nup = @\"x\""), {"up and front lie along the same axis"}},
    {inHead("origin = @\"crwn\""), {"did you mean \"crown\"?"}},
    {inHead("offset = @[1, 2]"), {"offset: found an array of 2, expected an array of 3"}},
    {inHead("offset = [1, 2, @1001]"), {"offset: found 1001"}},
    {inHead("landmarks = @2"), {"landmarks: found 2, expected a table"}},
    {inHead("landmarks = { @brow = 2 }"),
     {"unknown key 'brow' in landmarks; did you mean 'brows'"}},
    {inHead("landmarks = { brows = @\"eyes\", chin = @-1001 }"),
     {"brows: found the string \"eyes\", expected a number", "chin: found -1001"}},
};
INSTANTIATE_TEST_SUITE_P(Heads, MalformedStyle, testing::ValuesIn(heads));

std::string inCollider(const std::string& lines) {
    return withTables("[[collider]]\nmesh = \"me.glb\"\n" + lines);
}

const Malformed bodies[] = {
    {inHead("collide = @0"), {"collide: found 0, expected true or false"}},
    {inHead("collide = @\"no\""), {"collide: found the string \"no\", expected true or false"}},
    {inHead("gap = @-2.5"), {"gap: found -2.5, expected a number from -2 to 5 cm"}},
    {inHead("gap = @30"), {"30 mm would be 3"}},
    {inHead("friction = @-0.1"), {"friction: found -0.1, expected a number from 0 to 2"}},
    {withTables("@[[collider]]\nunit = \"mm\""),
     {"[[collider]] has no 'mesh', expected the path of what hair keeps out of"}},
    {withTables("[[collider]]\n@mehs = \"me.glb\""),
     {"unknown key 'mehs' in [[collider]]; did you mean 'mesh'?"}},
    {withTables("[[collider]]\nmesh = @\"none\""),
     {R"(mesh: found the string "none", expected "mannequin")"}},
    {withTables("[[collider]]\nmesh = @\"me.fbx\""),
     {R"(mesh: found the string "me.fbx", expected "mannequin" or a file that ends in .obj, .ply)"}},
    {withTables("[[collider]]\nmesh = \"mannequin\"\n@offset = [0, 1, 0]"),
     {"'offset' places a mesh from a file, and [[collider]] names none"}},
    {withTables("@[collider]\nmesh = \"me.glb\""),
     {"collider: found a table, expected [[collider]], one for each"}},
    {inCollider("up = @\"z\""), {"up and front lie along the same axis of the file"}},
    {inCollider("gap = @6"), {"gap: found 6, expected a number from -2 to 5 cm"}},
    {inCollider("friction = @3"), {"friction: found 3, expected a number from 0 to 2; 3 % would"}},
    {inCollider("@collide = true"),
     {"unknown key 'collide' in [[collider]]; it belongs in [head]"}},
    {withTables("[contact]\nlayers = @1\npacking = @0"),
     {"layers: found 1, expected true or false", "packing: found 0, expected a number from 0.001"}},
    {withTables("[contact]\npacking = @0.95"), {"to 0.9"}},
    {withTables("[contact]\n@friction = 1"), {"unknown key 'friction' in [contact]"}},
    {atTop("contact = @true"), {"contact: found true, expected the table [contact]"}},
};
INSTANTIATE_TEST_SUITE_P(Bodies, MalformedStyle, testing::ValuesIn(bodies));

const std::string spaced = "spacing = 0.5\n";

const Malformed surfaces[] = {
    {inScalp(spaced + "surface = @\"haed\""), {"did you mean \"head\"?"}},
    {inScalp(spaced + "surface = @\"head\"") + "[head]\nmesh = \"none\"\n",
     {"surface: hair is to grow from the head, but [head] has mesh = \"none\""}},
    {inScalp(spaced + "@groups = [\"scalp\"]"),
     {"'groups' is of a head's surface; write surface = \"head\" beside it"}},
    {inScalp(spaced + "@mask = \"a.png\"\nsurface = \"ellipsoid\""),
     {"'mask' is of a head's surface"}},
    {inScalp(spaced + "surface = \"head\"\ngroups = @\"scalp\""),
     {R"(groups: found the string "scalp", expected an array of names, as in ["scalp"])"}},
    {inScalp(spaced + "surface = \"head\"\ngroups = @[]"), {"expected an array of names"}},
    {inScalp(spaced + "surface = \"head\"\ngroups = [@1, @\"\"]"),
     {"groups: found 1, expected a name", "groups: found the string \"\", expected a name"}},
    {inScalp(spaced + "surface = \"head\"\nmask = @\"a.jpg\""),
     {R"(mask: found the string "a.jpg", expected a picture that ends in .png)"}},
    {inScalp(spaced + "surface = \"head\"\nmask = @0.5"), {"mask: found 0.5, expected a picture"}},
};
INSTANTIATE_TEST_SUITE_P(Surfaces, MalformedStyle, testing::ValuesIn(surfaces));

const Malformed leans[] = {
    {inHair("lift = @91"), {"lift: found 91, expected a number from 0 to 90 degrees"}},
    {inHair("@towards = \"back\""),
     {"'towards' says where hair leans to, which stands upright without 'lift'"}},
    {inHair("@whorl = { theta = 5 }"), {"'whorl' says where hair leans to"}},
    {inHair("lift = 5\ntowards = \"back\"\n@whorl = { theta = 5 }"),
     {"found both 'towards' and 'whorl', expected one of them"}},
    {inHair("lift = 5\ntowards = @\"bakc\""), {"did you mean \"back\"?"}},
    {inHair("lift = 5\ntowards = @[0, 0, 0]"), {"towards: found a zero vector"}},
    {inHair("lift = 5\ntowards = @5"), {"towards: found 5, expected a name as in \"z\""}},
    {inHair("lift = 5\nwhorl = @{ phi = 5 }"), {"whorl has no 'theta', expected a number of"}},
    {inHair("lift = 5\nwhorl = { theta = @-1, phi = @400, turn = @200 }"),
     {"theta: found -1", "phi: found 400", "turn: found 200, expected a number from -180 to 180"}},
};
INSTANTIATE_TEST_SUITE_P(Leans, MalformedStyle, testing::ValuesIn(leans));

const std::string rest = "[solver]\nmethod = \"equilibrium\"\n";

const Malformed natural[] = {
    {withTables("[solver]\nmethod = @\"rest\""),
     {R"(method: found the string "rest", expected "cantilever" or "equilibrium")"}},
    {inHair("@curl = { radius = 0.4, pitch = 1.5 }"),
     {"'curl' is not for the cantilever method; write method = \"equilibrium\" in [solver]"}},
    {inHair("@taper = 0.5"), {"'taper' is not for the cantilever method"}},
    {withTables("[solver]\n@grading = 1.5"), {"'grading' is not for the cantilever method"}},
    {inHair("curl = @{ radius = 0.4 }\n" + rest), {"expected a number of cm"}},
    {inHair("curl = { radius = @0, pitch = @60 }\n" + rest),
     {"radius: found 0", "pitch: found 60"}},
    {inHair("curl = @0.4\n" + rest), {"curl: found 0.4, expected a table"}},
    {inHair("curl = { radius = 0.4, pitch = 1.5 }\nwave = @{ amplitude = 1, length = 5 }\n" + rest),
     {"found 'wave' beside 'curl', expected one of them"}},
};
INSTANTIATE_TEST_SUITE_P(NaturalShapes, MalformedStyle, testing::ValuesIn(natural));

// A style of a groom that is right but for what is written.
std::string withGroom(const std::string& value, const std::string& hair = "") {
    return "kushi = 1\n[solver]\nmethod = \"equilibrium\"\n[[part]]\ngroom = " + value +
           "\n[part.hair]\n" + hair + "\n";
}

const Malformed grooms[] = {
    {"kushi = 1\n[[part]]\n@groom = \"scan.hair\"\n",
     {"'groom' is not for the cantilever method; write method = \"equilibrium\" in [solver]"}},
    {"kushi = 1\n@groom = \"scan.hair\"\n[solver]\nmethod = \"cantilever\"\n",
     {"'groom' is not for the cantilever method"}},
    {"kushi = 1\ngroom = \"scan.hair\"\n" + rest + "[@" + scalpTable.substr(1) + hairTable,
     {"found both 'scalp' and 'groom', expected one of them"}},
    {"kushi = 1\ngroom = @\"scan.hair\"\n" + rest + "[[part]]\ngroom = \"scan.hair\"\n",
     {"'groom' stands at the top, but the style has [[part]]"}},
    {withGroom("@5"), {"groom: found 5, expected a file of strands that ends in .hair, .ply"}},
    {withGroom("@\"\""), {"groom: found the string \"\", expected a file of strands"}},
    {withGroom("@\"scan.abc\""), {"groom: found the string \"scan.abc\", expected a file"}},
    {withGroom("@{ unit = \"mm\" }"), {"groom has no 'file', expected the path of its strands"}},
    {withGroom("{ file = @\"scan\" }"), {"file: found the string \"scan\", expected a file"}},
    {withGroom("{ file = @7 }"), {"file: found 7, expected a file of strands"}},
    {withGroom("{ file = \"a.ply\", @units = \"mm\" }"), {"in groom; did you mean 'unit'?"}},
    {withGroom("{ file = \"a.ply\", unit = @\"ft\" }"), {"unit: found the string \"ft\""}},
    {withGroom("{ file = \"a.ply\", unit = @0 }"), {"from 0.0001 to 10000 cm"}},
    {withGroom("{ file = \"a.ply\", up = @\"w\" }"), {"up: found the string \"w\""}},
    {withGroom("{ file = \"a.ply\", up = @\"-x\" }"),
     {"up and front lie along the same axis of the file (they are \"y\" and \"x\" where"}},
    {withGroom("{ file = \"a.ply\", offset = @[1, 2] }"), {"offset: found an array of 2"}},
    {withGroom("\"a.ply\"", "@length = 25\n@length_variation = 0.1\n@growth = \"radial\""),
     {"'length' is for hair that grows; the strands of a groom are as its file has them",
      "'length_variation' is for hair that grows", "'growth' is for hair that grows"}},
    {withGroom("\"a.ply\"", "@curl = { radius = 1, pitch = 1 }"),
     {"'curl' is for hair that grows"}},
    {withGroom("\"a.ply\"", "@wave = { amplitude = 1, length = 1 }"),
     {"'wave' is for hair that grows"}},
    {withGroom("\"a.ply\"", "@lift = 5\n@towards = \"back\""),
     {"'lift' is for hair that grows", "'towards' is for hair that grows"}},
    {withGroom("\"a.ply\"", "set = @1.5"), {"set: found 1.5, expected a number from 0 to 1"}},
    {withGroom("\"a.ply\"", "set = @50"), {"50 % would be 0.5"}},
    {inHair("@set = 1"), {"'set' is for the strands of a groom; hair that grows takes the shape"}},
};
// A style at rest, with a tie.
std::string withTie(const std::string& lines) {
    return "kushi = 1\n[solver]\nmethod = \"equilibrium\"\n" + scalpTable + hairTable +
           "[[tie]]\n" + lines + "\n";
}

const Malformed ties[] = {
    {"kushi = 1\n" + scalpTable + hairTable + "[[@tie]]\nat = [-12, 4, 0]\n",
     {"'tie' is not for the cantilever method; write method = \"equilibrium\" in [solver]"}},
    {withTie("at = @4"), {"at: found 4, expected an array of 3, each a number"}},
    {"kushi = 1\n[solver]\nmethod = \"equilibrium\"\n" + scalpTable + hairTable +
         "@[[tie]]\nat = [-5, 4, 0]\n",
     {"the tie lies inside the scalp's ellipsoid"}},
    {withTie("at = [-12, 4, 0]\nradius = @20"), {"radius: found 20, expected"}},
    {withTie("at = [-12, 4, 0]\nslack = @0"), {"slack: found 0, expected"}},
    {withTie("at = [-12, 4, 0]\n@width = 1"), {"unknown key 'width' in [[tie]]"}},
};
INSTANTIATE_TEST_SUITE_P(Ties, MalformedStyle, testing::ValuesIn(ties));
INSTANTIATE_TEST_SUITE_P(Grooms, MalformedStyle, testing::ValuesIn(grooms));

const Malformed colors[] = {
    {inHair("color = @5"), {"color: found 5, expected a name as in \"brown\", sRGB components"}},
    {inHair("color = @{ redness = 1 }"),
     {"color has no 'melanin', expected a number from 0 to 20"}},
    {inHair("color = { melanin = @-1 }"), {"melanin: found -1, expected a number from 0 to 20"}},
    {inHair("color = { melanin = 1, redness = @2 }"), {"redness: found 2, expected"}},
    {inHair("color = { @melanine = 1 }"), {"in color; did you mean 'melanin'?"}},
    {inHair("grey = @2"), {"grey: found 2, expected a number from 0 to 1"}},
    {inHair("grey = @true"), {"or a table, as in { share = 0.3, color = \"white\" }"}},
    {inHair("grey = @{ color = \"white\" }"), {"grey has no 'share'"}},
    {inHair("grey = { share = 1, color = @\"wite\" }"), {"did you mean \"white\"?"}},
    {inHair("@gray = 0.2"), {"did you mean 'grey'?"}},
    {inHair("tips = @\"blond\""), {"tips: found the string \"blond\", expected a table"}},
    {inHair("tips = @{ color = \"blond\" }"), {"tips has no 'length', expected a number of cm"}},
    {inHair("regrowth = @{ length = 3 }"), {"regrowth has no 'color', expected a colour"}},
    {inHair("regrowth = { color = \"grey\", length = 3, blend = @4 }"),
     {"blend: found 4, expected no more than the 'length'"}},
    {inHair("@regrow = 1"), {"did you mean 'regrowth'?"}},
    {inHair("@root_color = \"grey\""), {"unknown key 'root_color' in [hair]"}},
    {inHair("@[[highlight]]\nshare = 0.2"), {"[[highlight]] has no 'color', expected a colour"}},
    {inHair("[[highlight]]\ncolor = @\"blonde\""), {"did you mean \"blond\"?"}},
    {inHair("[[highlight]]\ncolor = \"blond\"\nfrom = 5\nto = @5"),
     {"to: found 5, expected more than 'from'"}},
    {inHair("[[highlight]]\ncolor = \"blond\"\n@foils = 1"), {"did you mean 'foil'?"}},
    {inHair("[[@highlights]]\ncolor = \"blond\""), {"did you mean 'highlight'?"}},
    {atTop("highlight = [@1]"), {"highlight: found"}},
};
INSTANTIATE_TEST_SUITE_P(Colors, MalformedStyle, testing::ValuesIn(colors));

const Malformed dress[] = {
    {inHair("clump = @1"), {"clump: found 1, expected a number from 0 to 0.9"}},
    {inHair("clump = @30"), {"30 % would be 0.3"}},
    {inHair("clump = @true"),
     {"clump: found true, expected a number from 0 to 0.9 or a table, as in { amount = 0.3"}},
    {inHair("clump = @{ size = 1 }"), {"clump has no 'amount', expected a number from 0 to 0.9"}},
    {inHair("clump = { amount = 0.3, size = @0 }"), {"size: found 0, expected a number from 0.1"}},
    {inHair("clump = { amount = 0.3, from = @1 }"), {"from: found 1, expected a number from 0"}},
    {inHair("clump = { amount = 0.3, variation = @2 }"), {"variation: found 2"}},
    {inHair("clump = { @ammount = 0.3 }"), {"in clump; did you mean 'amount'?"}},
    {inHair("@clumps = 0.3"), {"did you mean 'clump'?"}},
    {inHair("flyaway = @1.5"), {"flyaway: found 1.5, expected a number from 0 to 1"}},
    {inHair("flyaway = @\"some\""), {"flyaway: found the string \"some\", expected a number"}},
    {inHair("flyaway = @[0.1]"), {"or a table, as in { share = 0.015, distance = 1 }"}},
    {inHair("flyaway = @{ distance = 1 }"), {"flyaway has no 'share'"}},
    {inHair("flyaway = { share = 0.1, distance = @0 }"), {"distance: found 0, expected"}},
    {inHair("@fly_away = 0.3"), {"did you mean 'flyaway'?"}},
};
INSTANTIATE_TEST_SUITE_P(Dress, MalformedStyle, testing::ValuesIn(dress));

const Malformed several[] = {
    {"kushi = 1\n@sead = 5\n[solver]\nsegments = @0\n[scalp]\n# \xE6\xAB\x9B \xE9\xAB\xAA\n"
     "\"ellipsoid\" = { semi_axes = [10, @\"\xE9\xAB\xAA\", @\"12\"] }\ncount = @0\n"
     "[hair]\ntype = @\"thin\"\nlength = @-1\n[[cut]]\nbelow = @\"chinn\"\n",
     {"'sead'", "segments", "semi_axes: found the string \"\xE9\xAB\xAA\"", "semi_axes", "count",
      "type", "length", "\"chinn\""}},
    // The tables of a document may come in any order; its problems come in that of the text.
    {"kushi = 1\n[[cut]]\nbelow = @nan\n[hair]\nlength = @nan\n" + scalpTable +
         "[solver]\nsegments = @nan\n",
     {"below", "length", "segments"}},
};
INSTANTIATE_TEST_SUITE_P(SeveralProblems, MalformedStyle, testing::ValuesIn(several));

}  // namespace
}  // namespace kushi
