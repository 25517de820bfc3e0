// SPDX-License-Identifier: Apache-2.0
#include <kushi/shade.h>

#include <algorithm>

#include <gmock/gmock.h>

namespace kushi {
namespace {

float brightness(Rgb color) {
    return std::max({color.r, color.g, color.b});
}

TEST(StudioLights, PointSomewhere) {
    for (const Light& light : studioLights().distant) {
        EXPECT_NEAR(length(light.direction), 1, 1e-6);
    }
}

TEST(StudioLights, HaveTheirKeyInFrontAndAbove) {
    const std::vector<Light> lights = studioLights().distant;
    const auto key = std::max_element(lights.begin(), lights.end(), [](Light a, Light b) {
        return brightness(a.color) < brightness(b.color);
    });
    EXPECT_GT(key->direction.x, 0.3F);
    EXPECT_GT(key->direction.y, 0.3F);
}

TEST(StudioLights, DoNotBurnOutASkinColouredBall) {
    const Mesh ball = ellipsoidMesh({.center = {}, .semiAxes = {1, 1, 1}}, 40);
    for (const Rgb color : shadeMatt(ball, studioLights(), {0.75F, 0.6F, 0.5F})) {
        EXPECT_LT(brightness(color), 0.95F);
        EXPECT_GT(brightness(color), 0.1F);
    }
}

TEST(StudioLights, LightABandAcrossHairThatFallsFromTheCrown) {
    // A strand over the front of the head, from level to hanging, seen from the front: bright
    // somewhere on the way, and neither at its root nor where it hangs.
    std::vector<Vec3f> nodes;
    for (int i = 0; i <= 90; ++i) {
        nodes.push_back(Vec3d{std::sin(radians(i)), std::cos(radians(i)), 0}.as<float>());
    }
    Strands strands;
    strands.add(nodes, 1);
    const HairLook look = {.color = {}, .specularColor = {1, 1, 1}};
    std::vector<Rgb> colors(nodes.size());
    shade(strands, studioLights(), look, {50, 0.5F, 0}, colors);
    const auto brightest = std::max_element(
        colors.begin(), colors.end(), [](Rgb a, Rgb b) { return brightness(a) < brightness(b); });
    EXPECT_GT(brightness(*brightest), 0.2F);
    EXPECT_LT(brightness(colors.front()), 0.1F * brightness(*brightest));
    EXPECT_LT(brightness(colors.back()), 0.1F * brightness(*brightest));
}

}  // namespace
}  // namespace kushi
