// SPDX-License-Identifier: Apache-2.0
//
// The shipped hairstyles, settled and measured.
#include "cli/crossings.h"
#include "fields.h"

#include <kushi/draw.h>
#include <kushi/head.h>
#include <kushi/settle.h>

#include <algorithm>
#include <cstdio>
#include <filesystem>
#include <fstream>
#include <iterator>

#include <gtest/gtest.h>

namespace kushi::test {
namespace {

SettledGroom settled(const std::string& name, std::size_t count) {
    const Result<Style> style =
        readStyle(std::string(KUSHI_SOURCE_DIR) + "/styles/" + name + ".toml");
    EXPECT_TRUE(style.ok());
    SettleOptions options;
    options.count = count;
    options.cacheFolder = fieldCache();
    return std::move(*settle(*style, options));
}

TEST(ShippedStyles, AllAreValidAndSettle) {
    int styles = 0;
    for (const auto& entry :
         std::filesystem::directory_iterator(std::string(KUSHI_SOURCE_DIR) + "/styles")) {
        if (entry.path().extension() != ".toml") continue;
        const Result<Style> style = readStyle(entry.path().string());
        ASSERT_TRUE(style.ok()) << entry.path();
        EXPECT_FALSE(style->name.empty()) << entry.path();
        SettleOptions options;
        options.count = 200;
        options.cacheFolder = fieldCache();
        const Result<SettledGroom> groom = settle(*style, options);
        ASSERT_TRUE(groom.ok()) << entry.path();
        EXPECT_GT(groom->strands.size(), 150U) << entry.path();
        // At most one strand in a hundred hangs between two rests.
        EXPECT_LE(groom->report.unsettled, 2U) << entry.path();
        ++styles;
    }
    EXPECT_EQ(styles, 19);
}

// The first style that a stranger makes.
TEST(ShippedStyles, TheOneInTheReadmeWorks) {
    std::ifstream in(std::string(KUSHI_SOURCE_DIR) + "/README.md");
    const std::string text{std::istreambuf_iterator<char>(in), {}};
    const std::size_t begin = text.find("```toml\n") + 8;
    const Result<Style> style =
        parseStyle(text.substr(begin, text.find("```", begin) - begin), "README.md");
    ASSERT_TRUE(style.ok()) << toString(style.problems()[0]);
    SettleOptions options;
    options.count = 500;
    options.cacheFolder = fieldCache();
    EXPECT_GT(settle(*style, options)->strands.size(), 450U);
}

// Figure 9 (a): weightless hair is straight.
TEST(ShippedStyles, WithoutGravityHairIsStraight) {
    const SettledGroom groom = settled("fig09a-initial", 500);
    for (std::size_t i = 0; i < groom.strands.size(); ++i) {
        const auto nodes = groom.strands.strand(i);
        EXPECT_NEAR(length(nodes.back() - nodes.front()), polylineLength(nodes), 1e-5);
    }
}

// Figure 9 (b): the hair at the crown stands, and before the face avoidance throws hair outwards.
TEST(ShippedStyles, UnderGravityTheCrownStandsAndTheFrontBulges) {
    const SettledGroom groom = settled("fig09b-gravity", 4000);
    float highest = 0;
    float foremost = 0;
    float crown = 0;
    for (std::size_t i = 0; i < groom.strands.size(); ++i) {
        crown = std::max(crown, groom.strands.strand(i)[0].y);
        for (const Vec3f node : groom.strands.strand(i)) {
            highest = std::max(highest, node.y);
            foremost = std::max(foremost, node.x);
        }
    }
    EXPECT_GT(highest, crown + 0.03F);
    EXPECT_GT(foremost, 0.12F);  // the ellipsoid ends at 10.5 cm
}

// Mean z of the nodes on each side of the head.
std::pair<double, double> sidewaysMeans(const SettledGroom& groom) {
    double left = 0;
    double right = 0;
    std::size_t lefts = 0;
    std::size_t rights = 0;
    for (std::size_t i = 0; i < groom.strands.size(); ++i) {
        const auto nodes = groom.strands.strand(i);
        const bool isRight = nodes[0].z > 0;
        for (const Vec3f node : nodes) {
            (isRight ? right : left) += node.z;
            ++(isRight ? rights : lefts);
        }
    }
    return {left / static_cast<double>(lefts), right / static_cast<double>(rights)};
}

// Figure 9 (c) and (d): a force along z combs one half, then the other.
TEST(ShippedStyles, ForcesCombOneSideThenTheOther) {
    const auto [left, right] = sidewaysMeans(settled("fig09b-gravity", 2000));
    const auto [leftC, rightC] = sidewaysMeans(settled("fig09c-right", 2000));
    const auto [leftD, rightD] = sidewaysMeans(settled("fig09d-left", 2000));
    EXPECT_NEAR(leftC, left, 1e-9);
    EXPECT_GT(rightC, right + 0.003);
    EXPECT_NEAR(rightD, rightC, 1e-9);
    EXPECT_LT(leftD, left - 0.003);
}

// Figure 10: the fringe ends at the brows, the rest hangs lower and turns in.
TEST(ShippedStyles, TheBobHasAFringeAPartingAndEndsThatTurnIn) {
    const SettledGroom groom = settled("fig10-bob", 4000);
    double lowestFringe = 1;
    int turnedIn = 0;
    int hanging = 0;
    for (std::size_t i = 0; i < groom.strands.size(); ++i) {
        const auto nodes = groom.strands.strand(i);
        const Vec3f root = nodes[0];
        const Vec3f tip = nodes.back();
        if (root.x > 0.09F && std::abs(root.z) < 0.03F)
            lowestFringe = std::min<double>(lowestFringe, tip.y);
        if (tip.y > -0.06F) continue;
        ++hanging;
        const Vec3f before = nodes[nodes.size() - 4];
        if (std::hypot(tip.x, tip.z) < std::hypot(before.x, before.z)) ++turnedIn;
    }
    EXPECT_GT(lowestFringe, 0.0);
    EXPECT_GT(hanging, 1000);
    EXPECT_GT(turnedIn, hanging * 8 / 10);
}

// Figures 10 and 11: the styles that people wear.
class WornStyles : public testing::TestWithParam<const char*> {};

// As in the paper no scalp shows but at the parting and the hairline; how much of it, from the
// side, from behind and from above, at the style's own count and the drawn width.
TEST_P(WornStyles, CoverTheScalp) {
    const Result<Style> style =
        readStyle(std::string(KUSHI_SOURCE_DIR) + "/styles/" + GetParam() + ".toml");
    ASSERT_TRUE(style.ok());
    const SettledGroom groom = std::move(*settle(*style));
    EXPECT_GE(groom.strands.size(), 20000U);
    const Strands strands = withInnerPieces(groom);
    const Mesh head = mannequin();
    const std::vector<std::uint8_t> scalp = scalpTriangles(head);
    Bounds bounds = boundsOf(strands.nodes);
    for (const char* view : {"back", "three-quarter", "top"}) {
        const Camera camera = frame(bounds, *parseView(view), 1);
        const double share = countShowing(strands, head, scalp, camera, {}).share();
        RecordProperty(view, std::to_string(share));
        EXPECT_LT(share, 0.08) << view;
    }
}

// But for the segment that grows out of the skin.
TEST_P(WornStyles, DoNotPassThroughTheHead) {
    static const Mesh mesh = mannequin();
    static const Crossings body(mesh);
    static const Mesh headAlone = [] {
        Mesh head = mannequin();
        std::erase_if(head.triangles, [&](const auto& triangle) {
            const Vec3f vertex = head.vertices[triangle[0]];
            return vertex.y < (vertex.x > 0.02F ? -0.11F : -0.05F);
        });
        return head;
    }();
    static const Crossings head(headAlone);
    const SettledGroom groom = settled(GetParam(), 4000);
    int throughHead = 0;
    int throughBody = 0;
    for (std::size_t i = 0; i < groom.strands.size(); ++i) {
        const auto nodes = groom.strands.strand(i).subspan(1);
        throughHead += head.crosses(nodes) ? 1 : 0;
        throughBody += body.crosses(nodes) ? 1 : 0;
    }
    std::printf("%s: %.2f %% through the head, %.2f %% through head, neck or bust\n", GetParam(),
                0.025 * throughHead, 0.025 * throughBody);
    EXPECT_EQ(throughHead, 0);
}

INSTANTIATE_TEST_SUITE_P(ShippedStyles, WornStyles,
                         testing::Values("fig10-bob", "fig11a-side-parting", "fig11b-swept-back",
                                         "fig11c-ponytail", "fig11d-short"));

// Strands with a node before the face, below `height` [m].
int strandsBeforeTheFace(const SettledGroom& groom, double height) {
    int count = 0;
    for (std::size_t i = 0; i < groom.strands.size(); ++i) {
        const auto nodes = groom.strands.strand(i);
        count += std::ranges::any_of(nodes, [&](Vec3f node) {
            return node.x > 0.06F && std::abs(node.z) < 0.04F && node.y < height;
        });
    }
    return count;
}

TEST(ShippedStyles, LeaveTheFaceFree) {
    EXPECT_EQ(strandsBeforeTheFace(settled("fig10-bob", 8000), *landmarkHeight("eyes")), 0);
    EXPECT_EQ(strandsBeforeTheFace(settled("fig11b-swept-back", 8000), 0.06), 0);
    EXPECT_EQ(strandsBeforeTheFace(settled("fig11c-ponytail", 8000), 0.06), 0);
    EXPECT_EQ(strandsBeforeTheFace(settled("fig11d-short", 8000), *landmarkHeight("eyes")), 0);
}

// Figures 10 and 11 (a): what grows beside the parting falls to its own side.
double shareOnItsSide(const SettledGroom& groom, double partingPhi) {
    int all = 0;
    int right = 0;
    for (std::size_t i = 0; i < groom.strands.size(); ++i) {
        const auto nodes = groom.strands.strand(i);
        const EllipsoidAngles angles = headEllipsoid().angles(nodes[0].as<double>());
        const double past = degrees(angles.phi) - partingPhi;
        if (degrees(angles.theta) < 10 || degrees(angles.theta) > 50 || std::abs(past) > 60)
            continue;
        ++all;
        right += (nodes.back().z - nodes[0].z > 0) == (past > 0) ? 1 : 0;
    }
    return right / static_cast<double>(all);
}

TEST(ShippedStyles, HairFallsToItsSideOfTheParting) {
    EXPECT_GT(shareOnItsSide(settled("fig10-bob", 8000), 0), 0.95);
    EXPECT_GT(shareOnItsSide(settled("fig11a-side-parting", 8000), 15), 0.95);
}

// Figure 11 (b): the tips lie behind the roots, and behind the face.
TEST(ShippedStyles, SweptBackHairLiesBehind) {
    const SettledGroom groom = settled("fig11b-swept-back", 4000);
    for (std::size_t i = 0; i < groom.strands.size(); ++i) {
        const auto nodes = groom.strands.strand(i);
        EXPECT_LT(nodes.back().x, 0.01F);
    }
}

// Figure 11 (c): the rest ends at the knot; the tail hangs from it and narrows.
TEST(ShippedStyles, ThePonytailIsGatheredAndNarrows) {
    const SettledGroom groom = settled("fig11c-ponytail", 8000);
    const Vec3f knot = {-0.11F, 0.04F, 0};
    int rest = 0;
    int gathered = 0;
    double upper = 0;
    double lower = 0;
    for (std::size_t i = 0; i < groom.strands.size(); ++i) {
        const auto nodes = groom.strands.strand(i);
        if (length(nodes[0] - knot) > 0.025F) {
            ++rest;
            gathered += length(nodes.back() - knot) < 0.05F ? 1 : 0;
            continue;
        }
        for (const Vec3f node : nodes) {
            const double width = std::abs(node.z);
            if (std::abs(node.y + 0.05F) < 0.01F) upper = std::max(upper, width);
            if (std::abs(node.y + 0.17F) < 0.01F) lower = std::max(lower, width);
        }
    }
    EXPECT_GT(gathered, rest * 9 / 10);
    EXPECT_GT(lower, 0);
    EXPECT_LT(lower, 0.7 * upper);
}

// Figure 11 (d): the lower hair grows, the shorter it is.
TEST(ShippedStyles, ShortHairIsShorterBelow) {
    const SettledGroom groom = settled("fig11d-short", 8000);
    const auto meanLength = [&](float low, float high) {
        double sum = 0;
        int count = 0;
        for (std::size_t i = 0; i < groom.strands.size(); ++i) {
            const auto nodes = groom.strands.strand(i);
            if (nodes[0].y < low || nodes[0].y > high) continue;
            sum += polylineLength(nodes);
            ++count;
        }
        return sum / count;
    };
    EXPECT_LT(meanLength(-0.1F, -0.03F), 0.02);
    EXPECT_LT(meanLength(-0.03F, 0.03F), meanLength(0.03F, 0.08F) - 0.01);
    EXPECT_GT(meanLength(0.08F, 0.2F), 0.055);
}

// Long hair parts at the shoulders: some lies on the chest, some down the back, none across them.
TEST(ShippedStyles, LongHairFallsBeforeAndBehindTheShoulders) {
    const SettledGroom groom = settled("over-shoulders", 4000);
    const Mesh head = mannequin();
    const Crossings body(head);
    std::size_t before = 0;
    std::size_t behind = 0;
    for (std::size_t i = 0; i < groom.strands.size(); ++i) {
        const auto nodes = groom.strands.strand(i);
        EXPECT_FALSE(body.crosses(nodes)) << i;
        const Vec3f tip = nodes.back();
        EXPECT_LT(std::abs(tip.z), 0.13F) << i;
        if (tip.y > *landmarkHeight("shoulders")) continue;
        before += tip.x > -0.02F ? 1 : 0;
        behind += tip.x < -0.08F ? 1 : 0;
    }
    EXPECT_GT(before, groom.strands.size() / 10);
    EXPECT_GT(behind, groom.strands.size() / 3);
}

// Strands with a node beside the cheek and the ear of one side: +1 the right, -1 the left.
std::size_t strandsBesideTheCheek(const SettledGroom& groom, float side) {
    std::size_t count = 0;
    for (std::size_t i = 0; i < groom.strands.size(); ++i) {
        count += std::ranges::any_of(groom.strands.strand(i), [&](Vec3f node) {
            return node.x > -0.01F && node.x < 0.06F && node.y < -0.01F && node.y > -0.06F &&
                   side * node.z > 0.03F;
        });
    }
    return count;
}

TEST(ShippedStyles, HairIsTuckedBehindTheRightEarAlone) {
    const SettledGroom groom = settled("behind-ear", 4000);
    EXPECT_LT(strandsBesideTheCheek(groom, 1), groom.strands.size() / 200);
    EXPECT_GT(strandsBesideTheCheek(groom, -1), groom.strands.size() / 20);
}

// No strand passes through the hat, and all come out below it.
TEST(ShippedStyles, HairComesOutUnderTheHat) {
    const Result<Style> style = readStyle(std::string(KUSHI_SOURCE_DIR) + "/styles/hat.toml");
    ASSERT_TRUE(style.ok());
    const Result<std::vector<Mesh>> worn = collidersOf(*style);
    ASSERT_TRUE(worn.ok());
    ASSERT_EQ(worn->size(), 1U);
    const Crossings hat(worn->front());
    const SettledGroom groom = settled("hat", 4000);
    EXPECT_LE(groom.report.pushedOut, 4U);
    for (std::size_t i = 0; i < groom.strands.size(); ++i) {
        const auto nodes = groom.strands.strand(i);
        EXPECT_FALSE(hat.crosses(nodes)) << i;
        EXPECT_LT(nodes.back().y, -0.09F) << i;
    }
}

// Hair that no tie leads there, and that grows straight into the hat.
TEST(ShippedStyles, LooseHairComesOutUnderTheHatToo) {
    Result<Style> style = readStyle(std::string(KUSHI_SOURCE_DIR) + "/styles/hat.toml");
    ASSERT_TRUE(style.ok());
    const Result<std::vector<Mesh>> worn = collidersOf(*style);
    ASSERT_TRUE(worn.ok());
    const Crossings hat(worn->front());
    style->parts[0].ties.clear();
    SettleOptions options;
    options.count = 400;
    options.cacheFolder = fieldCache();
    options.measurePenetration = true;
    for (const double length : {0.1, 0.2, 0.4}) {
        style->parts[0].hair.length = length;
        const Result<SettledGroom> groom = settle(*style, options);
        ASSERT_TRUE(groom.ok());
        EXPECT_LE(groom->report.unsettled, 4U) << length;
        EXPECT_EQ(groom->report.penetration.at(0).found.strands, 0U) << length;
        for (std::size_t i = 0; i < groom->strands.size(); ++i)
            EXPECT_FALSE(hat.crosses(groom->strands.strand(i))) << length << ' ' << i;
    }
}

}  // namespace
}  // namespace kushi::test
