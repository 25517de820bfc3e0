// SPDX-License-Identifier: Apache-2.0
#include "render/projection.h"

#include <limits>

#include <gmock/gmock.h>

namespace kushi {
namespace {

// Looks along -x from x = 10 with 90 degrees of height: at distance d a metre is 50 / d samples.
Projection fromTheFront() {
    return {{.eye = {10, 0, 0}, .target = {}, .verticalFieldOfView = 1.5707964F}, 200, 100};
}

TEST(Projection, PutsThePersonsRightOnTheLeftAndUpOnTop) {
    const StoredPoint at = fromTheFront().store({0, 2, 4});
    EXPECT_NEAR(at.x, 100 - 4 * 5, 1e-4);
    EXPECT_NEAR(at.y, 50 - 2 * 5, 1e-4);
    EXPECT_NEAR(at.q, 0.1, 1e-7);
}

TEST(Projection, MarksWhatLiesBehind) {
    EXPECT_FALSE(fromTheFront().store({10, 1, 0}).inFront());
    EXPECT_FALSE(fromTheFront().store({20, 0, 0}).inFront());
    EXPECT_TRUE(fromTheFront().store({20, 0, 0}).drawable());
    EXPECT_TRUE(fromTheFront().store({9.98F, 0, 0}).inFront());
}

TEST(Projection, MarksWhatCannotBeDrawn) {
    const float infinity = std::numeric_limits<float>::infinity();
    EXPECT_FALSE(fromTheFront().store({0, infinity, 0}).drawable());
    EXPECT_FALSE(fromTheFront().store({0, 0, std::nanf("")}).drawable());
    EXPECT_FALSE(fromTheFront().store({0, 1e20F, 0}).drawable());
    EXPECT_FALSE(fromTheFront().store({-3e38F, 0, 0}).drawable());
}

TEST(Projection, TellsAMicrometreApartAtADepthOfAMetre) {
    const Projection projection({.eye = {0, 0, 0}, .target = {1, 0, 0}}, 100, 100);
    const double kept = 0x1p32;  // depth's lower bits make room for an id
    const double difference = projection.depth(1 / 1.000002) - projection.depth(1 / 1.000001);
    EXPECT_GE(difference, kept);
    EXPECT_EQ(projection.depth(0), Projection::fullDepth);
}

TEST(Projection, KnowsACameraThatLooksNowhere) {
    EXPECT_FALSE(Projection({.eye = {1, 1, 1}, .target = {1, 1, 1}}, 10, 10).valid());
    EXPECT_FALSE(Projection({.eye = {1, std::nanf(""), 1}, .target = {}}, 10, 10).valid());
    EXPECT_FALSE(
        Projection({.eye = {1, 0, 0}, .target = {}, .verticalFieldOfView = 0}, 10, 10).valid());
}

TEST(Projection, FindsSomeUpWhereTheCameraHasNone) {
    for (const Vec3f up : {Vec3f{0, 1, 0}, Vec3f{}, Vec3f{0, std::nanf(""), 0}}) {
        const Projection projection({.eye = {0, 5, 0}, .target = {}, .up = up}, 100, 100);
        const StoredPoint at = projection.store({0.1F, 0, 0.1F});
        EXPECT_TRUE(at.inFront());
        EXPECT_GT(std::hypot(at.x - 50, at.y - 50), 1);
    }
}

}  // namespace
}  // namespace kushi
