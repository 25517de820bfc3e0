// SPDX-License-Identifier: Apache-2.0
#include <kushi/shade.h>

#include <gmock/gmock.h>

namespace kushi {
namespace {

TEST(ShadeMatt, FollowsLambertsLaw) {
    Mesh mesh;
    mesh.vertices.resize(4);
    for (const double angle : {0.0, 60.0, 90.0, 150.0}) {
        const double a = radians(angle);
        mesh.normals.push_back(Vec3d{std::sin(a), std::cos(a), 0}.as<float>());
    }
    const Lights lights = {.ambient = {0.1F, 0.2F, 0.3F}, .distant = {{{0, 1, 0}, {1, 2, 0}}}};
    const std::vector<Rgb> colors = shadeMatt(mesh, lights, {0.5F, 0.25F, 1});
    ASSERT_EQ(colors.size(), 4U);
    const double cosines[] = {1, 0.5, 0, 0};  // nothing from behind
    for (std::size_t i = 0; i < 4; ++i) {
        EXPECT_NEAR(colors[i].r, 0.5 * (0.1 + 1 * cosines[i]), 1e-6) << i;
        EXPECT_NEAR(colors[i].g, 0.25 * (0.2 + 2 * cosines[i]), 1e-6) << i;
        EXPECT_NEAR(colors[i].b, 0.3, 1e-6) << i;
    }
}

TEST(ShadeMatt, AddsLights) {
    Mesh mesh;
    mesh.vertices.resize(1);
    mesh.normals = {{0, 0.6F, 0.8F}};
    const Lights lights = {.ambient = {},
                           .distant = {{{0, 1, 0}, {1, 0, 0}}, {{0, 0, 1}, {0, 1, 0}}}};
    const Rgb color = shadeMatt(mesh, lights, {1, 1, 1})[0];
    EXPECT_NEAR(color.r, 0.6, 1e-6);
    EXPECT_NEAR(color.g, 0.8, 1e-6);
}

}  // namespace
}  // namespace kushi
