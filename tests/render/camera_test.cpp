// SPDX-License-Identifier: Apache-2.0
#include "render/projection.h"

#include <kushi/camera.h>

#include <gmock/gmock.h>

namespace kushi {
namespace {

using ::testing::HasSubstr;

void expectNear(Vec3f a, Vec3d b) {
    EXPECT_NEAR(a.x, b.x, 1e-5);
    EXPECT_NEAR(a.y, b.y, 1e-5);
    EXPECT_NEAR(a.z, b.z, 1e-5);
}

Bounds unitBox() {
    Bounds bounds;
    bounds.include({0, 1, 2});
    bounds.include({2, 3, 4});
    return bounds;
}

Vec3f directionToEye(const std::string& view) {
    const Camera camera = frame(unitBox(), parseView(view).value(), 1);
    return normalized(camera.eye - camera.target);
}

TEST(ParseView, KnowsTheSidesOfTheHead) {
    expectNear(directionToEye("front"), {1, 0, 0});
    expectNear(directionToEye("back"), {-1, 0, 0});
    expectNear(directionToEye("left"), {0, 0, -1});
    expectNear(directionToEye("right"), {0, 0, 1});
    expectNear(directionToEye("top"), {0, 1, 0});
}

TEST(ParseView, TakesYawAndPitchInDegrees) {
    for (const char* text : {"30,-20", "30, -20", " +30 , -20 ", "30.0,-2e1"}) {
        const Result<View> view = parseView(text);
        ASSERT_TRUE(view.ok()) << text;
        EXPECT_NEAR(view->yaw, 0.5235987755982988, 1e-12) << text;
        EXPECT_NEAR(view->pitch, -0.3490658503988659, 1e-12) << text;
    }
    expectNear(directionToEye("90,0"), {0, 0, 1});
    expectNear(directionToEye("0,30"), {std::sqrt(0.75), 0.5, 0});
}

TEST(ParseView, SaysWhatItExpected) {
    const auto messageFor = [](const std::string& text) {
        const Result<View> view = parseView(text);
        EXPECT_FALSE(view.ok()) << text;
        return view.ok() ? std::string() : view.problems()[0].message;
    };
    EXPECT_THAT(messageFor("frnt"), HasSubstr("unknown view 'frnt', expected front, back, left"));
    EXPECT_THAT(messageFor(""), HasSubstr("unknown view ''"));
    EXPECT_THAT(messageFor("30"), HasSubstr("YAW,PITCH in degrees"));
    for (const char* text :
         {"30,", ",10", "30,ten", "1,2,3", "30;10,", "nan,0", "0,inf", "1e999,0"}) {
        EXPECT_THAT(messageFor(text), HasSubstr("is not two numbers")) << text;
    }
    EXPECT_THAT(messageFor("361,0"), HasSubstr("yaw of view '361,0' is not in [-360, 360]"));
    EXPECT_THAT(messageFor("0,-91"), HasSubstr("pitch of view '0,-91' is not in [-90, 90]"));
}

TEST(Frame, FillsThePictureWithTheBoxUpToAMargin) {
    for (const double aspect : {0.5, 1.0, 2.0}) {
        for (const View view : {View{0, 0}, View{2, 0.5}, View{0.3, radians(90)}}) {
            const int height = 1000;
            const int width = static_cast<int>(height * aspect);
            const Camera camera = frame(unitBox(), view, aspect);
            const Projection projection(camera, width, height);
            double fills = 0;
            for (const float x : {0.0F, 2.0F}) {
                for (const float y : {1.0F, 3.0F}) {
                    for (const float z : {2.0F, 4.0F}) {
                        const StoredPoint at = projection.store({x, y, z});
                        ASSERT_TRUE(at.inFront());
                        fills = std::max({fills, std::abs(2.0 * at.x / width - 1),
                                          std::abs(2.0 * at.y / height - 1)});
                    }
                }
            }
            EXPECT_NEAR(fills, 0.94, 1e-3);
            EXPECT_NEAR(length(camera.up), 1, 1e-5);
        }
    }
}

TEST(Frame, LooksDownWithTheFaceAtTheLowerBorder) {
    const Camera camera = frame(unitBox(), {.yaw = 0, .pitch = radians(90)}, 1);
    expectNear(camera.up, {-1, 0, 0});
    const Projection projection(camera, 100, 100);
    EXPECT_GT(projection.store({1.5F, 2, 3}).y, 50);
}

TEST(Frame, StandsBackFromNothing) {
    for (const Bounds& bounds : {Bounds{}, Bounds{{1, 2, 3}, {1, 2, 3}}}) {
        const Camera camera = frame(bounds, {}, 1);
        EXPECT_TRUE(isFinite(camera.eye));
        EXPECT_GT(length(camera.eye - camera.target), 0.1F);
    }
}

}  // namespace
}  // namespace kushi
