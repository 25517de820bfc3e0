// SPDX-License-Identifier: Apache-2.0
#include <kushi/shade.h>

#include <gtest/gtest.h>

namespace kushi {
namespace {

constexpr Ellipsoid ball = {.center = {0, 0, 0}, .semiAxes = {0.1, 0.1, 0.1}};
constexpr Rgb bare = {0.6F, 0.5F, 0.4F};
constexpr Rgb brown = {0.2F, 0.1F, 0.05F};

/// Hairs of 1 mm that stand `spacing` [m] apart on the ball, where `grows(theta, phi)`.
template <typename Where>
Strands grown(double spacing, Where grows) {
    Strands strands;
    for (double theta = 0.3; theta < 2.8; theta += spacing / 0.1) {
        for (double phi = -3; phi < 3; phi += spacing / (0.1 * std::sin(theta))) {
            if (!grows(theta, phi)) continue;
            const Vec3d root = ball.point({theta, phi});
            const Vec3f nodes[] = {root.as<float>(), (1.01 * root).as<float>()};
            strands.add(nodes, strands.size());
            strands.colors.insert(strands.colors.end(), {brown, {1, 0, 0}});
        }
    }
    return strands;
}

/// The tint of a single vertex 1 cm below the ball.
Rgb tintAt(const Strands& strands, double theta, double phi) {
    Mesh mesh;
    mesh.vertices = {(0.9 * ball.point({theta, phi})).as<float>()};
    return scalpTint(mesh, strands, ball, bare)[0];
}

const auto everywhere = [](double, double) { return true; };
const auto left = [](double, double phi) { return phi < 0; };

void expectNear(Rgb color, Rgb expected) {
    EXPECT_NEAR(color.r, expected.r, 1e-5);
    EXPECT_NEAR(color.g, expected.g, 1e-5);
    EXPECT_NEAR(color.b, expected.b, 1e-5);
}

TEST(ScalpTint, IsADarkenedRootColourAmongRoots) {
    const Strands strands = grown(0.002, everywhere);
    for (const double phi : {-2.0, -0.4, 0.0, 1.3})
        expectNear(tintAt(strands, 1.5, phi), 0.6F * brown);
}

TEST(ScalpTint, FadesAcrossTheHairline) {
    const Strands strands = grown(0.001, left);
    expectNear(tintAt(strands, 1.5, -0.1), 0.6F * brown);
    expectNear(tintAt(strands, 1.5, 0.1), bare);
    float before = 0;
    for (double phi = -0.08; phi <= 0.08; phi += 0.004) {
        const float red = tintAt(strands, 1.5, phi).r;
        EXPECT_GE(red, before - 0.01F) << phi;
        EXPECT_LT(red, std::max(before, 0.12F) + 0.08F) << phi;  // no visible edge
        before = red;
    }
    // Half of it at the hairline itself.
    EXPECT_NEAR(tintAt(strands, 1.5, 0).r, (0.6F * brown.r + bare.r) / 2, 0.1);
}

TEST(ScalpTint, IsFaintWhereHairsAreFew) {
    const Strands few = grown(0.005, everywhere);  // 4 a square centimetre
    const Rgb color = tintAt(few, 1.5, 0.4);
    EXPECT_GT(color.r, (0.6F * brown.r + bare.r) / 2 - 0.1F);
    EXPECT_LT(color.r, bare.r);
    Strands one;
    const Vec3f nodes[] = {{0, 0.1F, 0}, {0, 0.12F, 0}};
    one.add(nodes, 1);
    one.colors = {brown, brown};
    EXPECT_GT(tintAt(one, 0, 0).r, 0.75F * bare.r);
}

TEST(ScalpTint, LeavesWhatIsNoScalp) {
    const Strands strands = grown(0.002, everywhere);
    Mesh mesh;
    mesh.vertices = {{0.06F, 0, 0}, {0.16F, 0, 0}};  // 4 cm inside, 6 cm outside
    for (const Rgb color : scalpTint(mesh, strands, ball, bare))
        EXPECT_EQ(color, bare);
}

TEST(ScalpTint, WithoutHairOrItsColoursTheHeadIsBare) {
    EXPECT_EQ(tintAt({}, 1, 1), bare);
    Strands plain = grown(0.002, everywhere);
    plain.colors.clear();
    EXPECT_EQ(tintAt(plain, 1, 1), bare);
    EXPECT_TRUE(scalpTint({}, plain, ball, bare).empty());
}

}  // namespace
}  // namespace kushi
