// SPDX-License-Identifier: Apache-2.0
//
// Damaged files: the readers must return, and what they return must hold together.
#include "io/damage.h"
#include "io/hair_file.h"
#include "io/obj_file.h"
#include "io/ply_file.h"
#include "io/test_bytes.h"

#include <algorithm>
#include <cmath>

#include <gtest/gtest.h>

namespace kushi {
namespace {

using test::Dice;
using test::mutated;

void expectConsistent(const Strands& strands) {
    const std::size_t nodes = strands.nodes.size();
    ASSERT_EQ(strands.offsets.front(), 0U);
    ASSERT_EQ(strands.offsets.back(), nodes);
    ASSERT_TRUE(std::ranges::is_sorted(strands.offsets, std::less_equal<>()));
    for (const std::size_t size :
         {strands.diameters.size(), strands.transparency.size(), strands.colors.size()}) {
        ASSERT_TRUE(size == 0 || size == nodes);
    }
    ASSERT_TRUE(std::ranges::all_of(strands.nodes, [](Vec3f node) { return isFinite(node); }));
    ASSERT_TRUE(strands.keys.empty());
}

using Parse = Result<Strands> (*)(std::string_view bytes, const std::string& file);

void expectSurvival(Parse parse, const std::string& valid) {
    const Result<Strands> unharmed = parse(valid, "valid");
    ASSERT_TRUE(unharmed.ok()) << toString(unharmed.problems().front());
    Dice dice(1992);
    int refused = 0;
    constexpr int trials = 4000;
    for (int i = 0; i < trials; ++i) {
        SCOPED_TRACE("trial " + std::to_string(i));
        const Result<Strands> strands = parse(mutated(valid, dice), "mutated");
        if (strands) {
            expectConsistent(*strands);
        } else {
            ++refused;
            ASSERT_FALSE(strands.problems().front().message.empty());
        }
    }
    // Else the damage does not reach the checks.
    EXPECT_GT(refused, trials / 10);
    EXPECT_LT(refused, trials);
}

Strands groom() {
    Strands strands;
    for (const std::size_t count : {3U, 4U, 5U, 6U}) {
        std::vector<Vec3f> nodes(count, Vec3f{0.1F, 0, 0.03F});
        for (std::size_t k = 0; k < count; ++k)
            nodes[k].y = 0.02F * static_cast<float>(k);
        strands.add(nodes, 1);
    }
    strands.diameters.assign(strands.nodes.size(), 7.5e-5F);
    strands.transparency.assign(strands.nodes.size(), 0.25F);
    strands.colors.assign(strands.nodes.size(), {0.1F, 0.05F, 0.03F});
    return strands;
}

TEST(Mutation, HairFilesOfAnyDamageAreReadOrRefused) {
    expectSurvival(parseHair, *formatHair(groom(), "valid"));
}

TEST(Mutation, BinaryPlyFilesOfAnyDamageAreReadOrRefused) {
    expectSurvival(parsePly, *formatPly(groom(), "valid"));
}

TEST(Mutation, TextPlyFilesOfAnyDamageAreReadOrRefused) {
    expectSurvival(parsePly,
                   "ply\nformat ascii 1.0\nelement extra 2\nproperty list uchar int a\n"
                   "element vertex 5\nproperty float x\nproperty float y\nproperty float z\n"
                   "property uchar red\nproperty uchar green\nproperty uchar blue\n"
                   "element edge 3\nproperty int vertex1\nproperty int vertex2\nend_header\n"
                   "2 7 8\n0\n1.5 2.5 3.5 1 2 3\n0 0 0 0 0 0\n1 1 1 1 1 1\n2 2 2 2 2 2\n"
                   "3 3 3 3 3 3\n0 1\n1 2\n4 3\n");
}

TEST(Mutation, ObjFilesOfAnyDamageAreReadOrRefused) {
    expectSurvival(parseObj,
                   *formatObj(groom(), "valid") +
                       "v 1 2 3\nv 4 5 6\nv 7 8 9 # end\nl -3/1 -2/1\nl -2 -1\np \\\n1\n");
}

}  // namespace
}  // namespace kushi
