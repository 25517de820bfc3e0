// SPDX-License-Identifier: Apache-2.0
// Light is neither made nor lost.
#include "trace/test_scene.h"

#include <gtest/gtest.h>

namespace kushi {
namespace {

using namespace test;

// White furnace: under a white sky, what takes no light is as bright as the sky, everywhere.
TEST(Trace, ShowsNothingOfClearHairAndAWhiteHeadUnderAWhiteSky) {
    const Strands strands = hairsOnBall(1500);
    const Mesh head = ball();
    const std::vector<Rgb> skin(head.vertices.size(), white);
    TraceOptions options = small(256);
    options.bounces = 10000;
    options.background = white;
    TraceLook look = whiteLook();
    look.color = {1, 1, 1};
    const Result<Traced> traced =
        trace(strands, head, skin, onlyDome(), cameraAt({1.2F, 0.5F, 1}), look, options);
    ASSERT_TRUE(traced.ok());
    const Rgb mean = meanOf(traced->image);
    std::printf("%g %g %g noise %g\n", mean.r, mean.g, mean.b, traced->noise);
    for (const Rgb pixel : traced->image.pixels) EXPECT_NEAR(pixel.g, 1, 0.02);
}

}  // namespace
}  // namespace kushi
