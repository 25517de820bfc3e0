// SPDX-License-Identifier: Apache-2.0
//
// The shipped hairstyles, settled and measured.
#include <kushi/settle.h>

#include <algorithm>
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
    return std::move(*settle(*style, options));
}

TEST(ShippedStyles, AllAreValidAndSettle) {
    int styles = 0;
    for (const auto& entry :
         std::filesystem::directory_iterator(std::string(KUSHI_SOURCE_DIR) + "/styles")) {
        const Result<Style> style = readStyle(entry.path().string());
        ASSERT_TRUE(style.ok()) << entry.path();
        EXPECT_FALSE(style->name.empty()) << entry.path();
        SettleOptions options;
        options.count = 200;
        EXPECT_GT(settle(*style, options)->strands.size(), 150U) << entry.path();
        ++styles;
    }
    EXPECT_GE(styles, 5);
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

}  // namespace
}  // namespace kushi::test
