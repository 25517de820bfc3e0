// SPDX-License-Identifier: Apache-2.0
#include "render/test_scene.h"

#include <kushi/draw.h>

#include <gmock/gmock.h>

namespace kushi {
namespace {

using namespace test;

/// A plate of 40 x 40 pixels, its left half marked.
struct Plate {
    Mesh mesh;
    std::vector<std::uint8_t> marked = {1, 1, 0, 0};
    Hairs hairs;

    Plate() {
        addRectangle(mesh, {-20, -20, 0}, {0, 20, 0}, red);
        addRectangle(mesh, {0, -20, 0}, {20, 20, 0}, blue);
    }
    Showing count(int supersample = 1, int threads = 0) const {
        const DrawOptions options = {
            .width = 80, .height = 60, .supersample = supersample, .threads = threads};
        return countShowing(hairs.strands, mesh, marked, pixelCamera(60), options);
    }
};

TEST(CountShowing, CountsTheSamplesOfWhatIsMarked) {
    EXPECT_EQ(Plate().count(1).bare, 800U);
    EXPECT_EQ(Plate().count(2).bare, 3200U);
    EXPECT_EQ(Plate().count(4).bare, 12800U);
    EXPECT_EQ(Plate().count(4).seen, 12800U);
    EXPECT_EQ(Plate().count().share(), 1);
}

TEST(CountShowing, TakesOffWhatHairCovers) {
    Plate plate;
    plate.hairs.add({{-30, 5.5F, 1}, {30, 5.5F, 1}}, black);  // 20 samples before the marked half
    plate.hairs.add({{-30, 5.5F, 2}, {30, 5.5F, 2}}, black);  // the same again
    plate.hairs.add({{-30, -5.5F, -1}, {30, -5.5F, -1}}, black);  // behind
    EXPECT_EQ(plate.count().bare, 800U);
    EXPECT_EQ(plate.count().seen, 780U);
    EXPECT_DOUBLE_EQ(plate.count().share(), 780.0 / 800);
}

TEST(CountShowing, DoesNotCountWhatTheRestOfTheHeadHides) {
    Plate plate;
    addRectangle(plate.mesh, {-15, -25, 3}, {-5, 25, 3}, green);  // a bar over half of it
    plate.marked.insert(plate.marked.end(), {0, 0});
    const Showing showing = plate.count();
    EXPECT_NEAR(static_cast<double>(showing.bare), 400, 40);  // nearer, so 3 % wider
    EXPECT_EQ(showing.seen, showing.bare);
    plate.marked.assign(6, 0);
    EXPECT_EQ(plate.count().bare, 0U);
    EXPECT_EQ(plate.count().share(), 0);
}

TEST(CountShowing, AgreesWithThePicture) {
    Plate plate;
    for (int i = 0; i < 30; ++i) {
        const auto x = static_cast<float>(i) - 25;
        plate.hairs.add({{x, 22, -2}, {x + 8, -22, 4}}, green);
    }
    const DrawOptions options = {.width = 80, .height = 60, .supersample = 1};
    std::size_t reds = 0;
    for (const Rgb pixel : drawn(plate.hairs, plate.mesh, options).pixels) {
        reds += static_cast<std::size_t>(pixel.r > 0.99F);
    }
    EXPECT_EQ(plate.count().seen, reds);
    EXPECT_LT(reds, 800U);
    for (const int threads : {1, 2, 8})
        EXPECT_EQ(plate.count(1, threads).seen, reds);
}

TEST(CountShowing, SeesNothingWhereSizesDoNotFit) {
    Plate plate;
    plate.marked.pop_back();
    EXPECT_EQ(plate.count().bare, 0U);
    EXPECT_EQ(Plate().count(3).bare, 0U);
}

}  // namespace
}  // namespace kushi
