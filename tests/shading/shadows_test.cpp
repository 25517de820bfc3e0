// SPDX-License-Identifier: Apache-2.0
#include "shading/lattice.h"

#include <kushi/shadows.h>

#include <array>
#include <cstring>

#include <gtest/gtest.h>

namespace kushi {
namespace {

const Lights lights = {.ambient = {1, 1, 1},
                       .distant = {{{1, 0, 0}, {1, 1, 1}}, {{0, 1, 0}, {1, 1, 1}}}};

Mesh ball() {
    return ellipsoidMesh({.center = {}, .semiAxes = {0.1, 0.1, 0.1}, .rotateZ = 0}, 40);
}

TEST(Shadows, TheHeadHidesItsOtherSide) {
    const Shadows shadows({}, ball(), lights);
    std::array<Passage, 2> passages;
    shadows.at({0.12F, 0, 0}, {1, 0, 0}, passages);
    EXPECT_EQ(passages[0].free, 1);
    shadows.at({-0.12F, 0, 0}, {1, 0, 0}, passages);
    EXPECT_EQ(passages[0].free, 0);
    EXPECT_EQ(passages[0].crossings, 0);
    EXPECT_EQ(passages[1].free, 1);
}

TEST(Shadows, HairHidesByHowMuchOfItThereIs) {
    const Shadows shadows(test::lattice(40, 0.0051F, 0.3F, 0.0012F), {}, lights);
    std::array<Passage, 2> passages;
    shadows.at({-0.105F, 0.15F, 0}, {1, 0, 0}, passages);
    EXPECT_NEAR(passages[0].crossings, 40 * 1.2 / 5.1, 0.8);
    EXPECT_NEAR(passages[1].crossings, 0, 0.05);
    EXPECT_EQ(passages[0].free, 1);
    shadows.at({0.11F, 0.15F, 0}, {1, 0, 0}, passages);
    EXPECT_NEAR(passages[0].crossings, 0, 0.2);
}

TEST(Shadows, TheSkyIsOpenOnOneSideOfHair) {
    const Shadows shadows(test::lattice(40, 0.0051F, 0.3F, 0.0012F), {}, lights);
    std::array<Passage, 2> passages;
    const Shadows::Sky out = shadows.at({0.1F, 0.15F, 0}, {1, 0, 0}, passages);
    EXPECT_LT(out.here.crossings, 1);
    EXPECT_GT(out.beyond.crossings, 2);
    const Shadows::Sky in = shadows.at({0.1F, 0.15F, 0}, {-1, 0, 0}, passages);
    EXPECT_NEAR(in.here.crossings, out.beyond.crossings, 1e-5);
    EXPECT_NEAR(in.beyond.crossings, out.here.crossings, 1e-5);
    EXPECT_NEAR(out.here.free, 1, 1e-6);
}

TEST(Shadows, TheSameFromAnyNumberOfThreads) {
    const Strands hair = test::lattice(20, 0.005F, 0.2F, 2e-4F);
    const Shadows one(hair, ball(), lights, 1);
    const Shadows three(hair, ball(), lights, 3);
    for (float x = -0.12F; x < 0.12F; x += 0.017F) {
        std::array<Passage, 2> a;
        std::array<Passage, 2> b;
        const Shadows::Sky skyA = one.at({x, 0.1F, 0.02F}, {0, 0, 1}, a);
        const Shadows::Sky skyB = three.at({x, 0.1F, 0.02F}, {0, 0, 1}, b);
        EXPECT_EQ(std::memcmp(&a, &b, sizeof a), 0);
        EXPECT_EQ(std::memcmp(&skyA, &skyB, sizeof skyA), 0);
    }
}

TEST(Shadows, WithoutAnythingAllIsLit) {
    const Shadows shadows({}, {}, lights);
    std::array<Passage, 2> passages;
    const Shadows::Sky sky = shadows.at({0, 0, 0}, {0, 1, 0}, passages);
    EXPECT_EQ(passages[1].free, 1);
    EXPECT_EQ(passages[1].crossings, 0);
    EXPECT_EQ(sky.here.free, 1);
    EXPECT_EQ(sky.here.crossings, 0);
}

}  // namespace
}  // namespace kushi
