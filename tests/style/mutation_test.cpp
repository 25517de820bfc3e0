// SPDX-License-Identifier: Apache-2.0
#include <kushi/style.h>

#include <algorithm>
#include <cmath>
#include <random>

#include <gtest/gtest.h>

namespace kushi {
namespace {

const std::string whole = R"(# a style with everything
kushi = 1
name = "bob"  # 櫛
seed = 0x7C8
gravity = [0, -1.0, 0]
[head]
mesh = "none"
gap = 0.1
[[collider]]
mesh = "hat.stl"
origin = "crown"
friction = 0.5
[contact]
layers = true
packing = 0.5
[solver]
method = "cantilever"
segments = 2_4
avoidance_steps = 4
[[part]]
name = 'tail "1"'
[part.scalp]
ellipsoid = { center = [0, 0, 0], semi_axes = [10.5, 12.5, 8.5], rotate_z = 20 }
spacing = 1.3e-1
jitter = 0.5
edge = 0.8
regions = [ { theta = [0, 100], phi = [-180, 180] }, ]
[part.hair]
type = "medium"
length = 25.0
flexural_rigidity = 7.8e-9
color = [0.4, 0.3, 0.2]
[[part.force]]
roots = { theta = [0, 90] }
within = { y = [-inf, "brows"], z = [0, inf] }
direction = [0, 1, 0]
falloff.cm = 1
[[part.cut]]
roots.where = "sides"
keep = [[-4, 2.0],
        [8, 6.0]]
mode = """hide"""
)";

const std::string scanned = R"(kushi = 1
[solver]
method = "equilibrium"
[[part]]
groom = { file = "a.hair", unit = "mm", up = "z", front = "-y", offset = [0, 1, 2] }
hair.set = 0.5
hair.stiffness = 2
)";

/// One small random damage after another; the same ones on every machine.
class Mutator {
public:
    explicit Mutator(std::uint32_t seed) : random_(seed) {}

    std::string mutate(std::string text) {
        const std::size_t count = 1 + below(2);
        for (std::size_t i = 0; i < count && !text.empty(); ++i)
            damage(text);
        return text;
    }

    std::size_t below(std::size_t limit) { return random_() % limit; }

private:
    void damage(std::string& text) {
        const std::size_t at = below(text.size());
        const std::size_t other = below(text.size());
        const std::size_t size = 1 + below(12);
        switch (below(6)) {
            case 0:
                text[at] = static_cast<char>(below(256));
                break;
            case 1:
                text.erase(at, size);
                break;
            case 2:
                text.insert(at, text.substr(other, size));
                break;
            case 3:
                std::swap(text[at], text[other]);
                break;
            case 4:
                text.insert(at, fragments[below(std::size(fragments))]);
                break;
            default:
                text.insert(lineStart(text, at), line(text, other));
                break;
        }
    }

    static std::size_t lineStart(const std::string& text, std::size_t at) {
        return text.rfind('\n', at) == std::string::npos ? 0 : text.rfind('\n', at) + 1;
    }

    static std::string line(const std::string& text, std::size_t at) {
        const std::size_t start = lineStart(text, at);
        return text.substr(start, text.find('\n', start) - start + 1);
    }

    static constexpr const char* fragments[] = {"[",        "]",          "{",
                                                "}",        "=",          ",",
                                                ".",        "\"",         "'",
                                                R"(""")",   "'''",        "#",
                                                "\\",       "\n",         "\r\n",
                                                "\r",       "inf",        "nan",
                                                "-",        "1e400",      "1e-9",
                                                "0x",       "1979-05-27", "true",
                                                "a.b.c",    "[[x]]",      "[x]",
                                                "x=",       "_",          "e",
                                                "\xC3",     "\xE6\xAB",   "\xEF\xBB\xBF",
                                                "07:32:00", "1_0",        "{}",
                                                "[]",       "\\u0000",    "\t",
                                                "+"};
    std::mt19937 random_;
};

bool isSound(const Problem& problem, const std::string& text) {
    const auto lines = 1 + std::ranges::count(text, '\n');
    return !problem.message.empty() && problem.file == "f" && problem.line >= 0 &&
           problem.line <= lines && (problem.line == 0) == (problem.column == 0);
}

bool isSound(const Style& style) {
    return !style.parts.empty() && std::ranges::all_of(style.parts, [](const Part& part) {
        if (part.groom) return !part.groom->path.empty();
        return std::isfinite(part.hair.rigidity()) && part.hair.length > 0 &&
               isFinite(part.scalp.ellipsoid.semiAxes) && !part.scalp.regions.empty() &&
               part.scalp.spacing.has_value() != part.scalp.count.has_value();
    });
}

TEST(Mutations, GiveASoundStyleOrSoundProblems) {
    ASSERT_TRUE(parseStyle(whole, "f"));
    ASSERT_TRUE(parseStyle(scanned, "f"));
    Mutator mutator(1992);
    int valid = 0;
    for (int i = 0; i < 8000; ++i) {
        const std::string text = mutator.mutate(i % 4 == 0 ? scanned : whole);
        const auto style = parseStyle(text, "f");
        if (style) {
            ++valid;
            ASSERT_TRUE(isSound(*style)) << text;
            continue;
        }
        ASSERT_FALSE(style.problems().empty());
        for (const Problem& problem : style.problems()) {
            ASSERT_TRUE(isSound(problem, text)) << toString(problem) << '\n' << text;
        }
    }
    EXPECT_GT(valid, 100);  // both ways are taken
}

// Whatever the text: an edit that is accepted gives a style that has the value.
TEST(Mutations, AreEditedSoundlyOrNotAtAll) {
    Mutator mutator(7);
    int edited = 0;
    for (int i = 0; i < 3000; ++i) {
        const std::string text = mutator.mutate(whole);
        const auto changed = withValue(text, "part[0].hair.stiffness", 0.5);
        if (!changed) continue;
        ++edited;
        const auto style = parseStyle(*changed, "f");
        ASSERT_TRUE(style) << *changed;
        ASSERT_EQ(style->parts[0].hair.stiffness, 0.5) << *changed;
    }
    EXPECT_GT(edited, 50);
}

}  // namespace
}  // namespace kushi
