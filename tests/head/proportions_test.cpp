// SPDX-License-Identifier: Apache-2.0
#include "head/measure.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include <gtest/gtest.h>

// The figures are those of an adult head in centimetres; 5 % either way.
namespace kushi {
namespace {

constexpr double share = 0.05;

bool onHead(Vec3d p) {
    return p.y > -5;
}
bool nearMiddle(Vec3d p) {
    return std::abs(p.z) < 0.5;
}

double vertexHeight() {
    return farthest({0, 1, 0}, onHead).y;
}

double chinHeight() {
    return farthest({0, -1, 0}, [](Vec3d p) { return p.x > 4 && p.y > -13; }).y;
}

Vec3d noseTip() {
    return farthest({1, 0, 0}, [](Vec3d p) { return nearMiddle(p) && p.y > -5 && p.y < 0; });
}

/// How far the head reaches to the right at a height and depth.
double reach(double x, double y) {
    const auto hit = firstHit({x, y, 30}, {0, 0, -1});
    return hit ? hit->z : -std::numeric_limits<double>::infinity();
}

/// Top and bottom of the ear: where, going down its middle, the surface steps out and back most.
struct EarSpan {
    double top = 0, bottom = 0;
};

EarSpan earSpan() {
    constexpr double step = 0.1;
    EarSpan span;
    double rise = 0;
    double fall = 0;
    for (int i = 0; i < 90; ++i) {
        const double y = 3 - i * step;
        const double change = reach(-2.2, y - step) - reach(-2.2, y);
        if (y > -1 && change > rise) {
            rise = change;
            span.top = y - step / 2;
        }
        if (y < -1 && -change > fall) {
            fall = -change;
            span.bottom = y - step / 2;
        }
    }
    return span;
}

TEST(MannequinProportions, IsAsLongAsAHeadFromGlabellaToTheBack) {
    const double glabella =
        farthest({1, 0, 0}, [](Vec3d p) { return nearMiddle(p) && p.y > 1.5 && p.y < 3.5; }).x;
    const double back = farthest({-1, 0, 0}, onHead).x;
    EXPECT_NEAR(glabella - back, 19.5, 19.5 * share);
}

TEST(MannequinProportions, IsAsBroadAsAHeadAboveTheEars) {
    const double right = farthest({0, 0, 1}, [](Vec3d p) { return p.y > 2.6; }).z;
    EXPECT_NEAR(2 * right, 15.3, 15.3 * share);
}

TEST(MannequinProportions, IsAsHighAsAHeadFromChinToVertex) {
    EXPECT_NEAR(vertexHeight() - chinHeight(), 22.5, 22.5 * share);
    EXPECT_NEAR(landmarkHeight("crown").value(), vertexHeight() / 100, 0.001);
    EXPECT_NEAR(landmarkHeight("chin").value(), chinHeight() / 100, 0.001);
}

// The ball and its lids are what stands out between the socket's upper and lower hollow; their
// middle is that of the stretch within two millimetres of the foremost point.
TEST(MannequinProportions, HasItsEyesAtHalfItsHeight) {
    const auto depth = [](double y) {
        return firstHit({30, y, 3.1}, {-1, 0, 0}).value_or(Vec3d{}).x;
    };
    double foremost = 0;
    for (int i = 0; i < 32; ++i)
        foremost = std::max(foremost, depth(-0.7 + 0.05 * i));
    double top = 0.2;
    double bottom = 0.2;
    while (depth(top) > foremost - 0.2)
        top += 0.02;
    while (depth(bottom) > foremost - 0.2)
        bottom -= 0.02;
    const double height = (top + bottom) / 2;
    const double size = vertexHeight() - chinHeight();
    EXPECT_NEAR(height, (vertexHeight() + chinHeight()) / 2, size * share);
    EXPECT_NEAR(landmarkHeight("eyes").value(), height / 100, 0.003);
}

TEST(MannequinProportions, HasEarsOfSixCentimetresBetweenBrowAndNoseBase) {
    const EarSpan ear = earSpan();
    EXPECT_NEAR(ear.top - ear.bottom, 6, 6 * share);
    EXPECT_LT(ear.top, 100 * landmarkHeight("brows").value());
    EXPECT_GT(ear.bottom, -5);
    EXPECT_NEAR(landmarkHeight("ears").value(), (ear.top + ear.bottom) / 200, 0.003);
}

TEST(MannequinProportions, HasTheTipOfTheNoseAndTheLipsWhereTheLandmarksSay) {
    EXPECT_NEAR(landmarkHeight("nose").value(), noseTip().y / 100, 0.003);
    const double lips = farthest({-1, 0, 0}, [](Vec3d p) {
                            return std::abs(p.z) < 0.1 && p.x > 0 && p.y < -6.2 && p.y > -7;
                        }).y;
    EXPECT_NEAR(landmarkHeight("lips").value(), lips / 100, 0.002);
}

TEST(MannequinProportions, PartsTheFaceInThirdsBelowTheHairline) {
    const double hairline = landmarkHeight("hairline").value();
    const double brows = landmarkHeight("brows").value();
    const double chin = landmarkHeight("chin").value();
    const double third = (hairline - chin) / 3;
    EXPECT_NEAR(hairline - brows, third, 0.1 * third);
}

TEST(MannequinProportions, HasShouldersOfThirtyEightCentimetresAndALevelBase) {
    const Vec3d shoulder = farthest({0, 0, 1}, [](Vec3d) { return true; });
    EXPECT_NEAR(2 * shoulder.z, 38, 38 * share);
    const double top = farthest({0, 1, 0}, [](Vec3d p) { return p.z > 14 && p.z < 15; }).y;
    EXPECT_NEAR(landmarkHeight("shoulders").value(), top / 100, 0.003);
    const double base = farthest({0, -1, 0}, [](Vec3d) { return true; }).y;
    EXPECT_GT(base, -36);
    EXPECT_LT(base, -32);
}

TEST(MannequinProportions, LandmarksGoFromTheTopDown) {
    double above = 1;
    for (const Landmark& landmark : headLandmarks()) {
        EXPECT_LE(landmark.y, above) << landmark.name;
        above = landmark.y;
        EXPECT_EQ(landmarkHeight(landmark.name), landmark.y);
    }
    EXPECT_EQ(headLandmarks().size(), 10U);
    EXPECT_FALSE(landmarkHeight("knee"));
}

}  // namespace
}  // namespace kushi
