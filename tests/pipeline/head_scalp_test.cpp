// SPDX-License-Identifier: Apache-2.0
#include "io/temp_folder.h"
#include "io/test_bytes.h"

#include <kushi/head.h>
#include <kushi/settle.h>

#include <algorithm>
#include <set>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

namespace kushi {
namespace {

Style onHead(int count) {
    Style style;
    style.headCollides = false;
    Part part;
    part.name = "hair";
    part.scalp.ellipsoid = headEllipsoid();
    part.scalp.count = count;
    part.scalp.surface = ScalpSurface::Head;
    part.scalp.groups = {"scalp"};
    part.hair.length = 0.1;
    style.parts = {part};
    return style;
}

SettledGroom settled(const Style& style, const SettleOptions& options = {}) {
    Result<SettledGroom> groom = settle(style, options);
    EXPECT_TRUE(groom.ok()) << toString(groom.problems()[0]);
    return groom ? std::move(*groom) : SettledGroom{};
}

TEST(HairOnAHead, StartsOnItsSurface) {
    const Mesh head = mannequin();
    const SettledGroom groom = settled(onHead(300));
    ASSERT_EQ(groom.strands.size(), 300U);
    for (std::size_t i = 0; i < groom.strands.size(); ++i) {
        const Vec3f root = groom.strands.strand(i)[0];
        float least = 1;
        for (const Vec3f vertex : head.vertices)
            least = std::min(least, length(vertex - root));
        // No triangle of the scalp is larger; the ellipsoid is up to 1.5 cm off.
        EXPECT_LT(least, 0.008F);
    }
}

TEST(HairOnAHead, TakesPreviewsFromItsFolliclesAndPlantsMoreAnew) {
    SettleOptions options;
    const SettledGroom all = settled(onHead(400));
    options.count = 100;
    const SettledGroom some = settled(onHead(400), options);
    EXPECT_EQ(some.strands.size(), 100U);
    const std::set<std::uint64_t> keys(all.strands.keys.begin(), all.strands.keys.end());
    for (const std::uint64_t key : some.strands.keys)
        EXPECT_TRUE(keys.contains(key));
    options.count = 600;
    EXPECT_EQ(settled(onHead(400), options).strands.size(), 600U);
}

// The same style on another head: forces and cuts go by the ellipsoid's angles.
TEST(HairOnAHead, GoesByTheSameAnglesOnAnotherHead) {
    const Ellipsoid skull = {{0.005, 0, 0}, {0.09, 0.11, 0.075}, 0};
    const Mesh mesh = ellipsoidMesh(skull, 60);
    std::string obj = "o scalp\n";
    for (const Vec3f v : mesh.vertices) {
        obj += "v " + std::to_string(-100 * v.z) + ' ' + std::to_string(100 * v.y) + ' ' +
               std::to_string(100 * v.x) + '\n';
    }
    for (const auto& [a, b, c] : mesh.triangles) {
        obj += "f " + std::to_string(a + 1) + ' ' + std::to_string(b + 1) + ' ' +
               std::to_string(c + 1) + '\n';
    }
    const test::TempFolder folder;
    test::writeBytes(folder.path("skull.obj"), obj);

    Style style = onHead(2000);
    style.headMesh = folder.path("skull.obj");
    style.headPlacement.origin = MeshOrigin::File;
    style.parts[0].scalp.regions = {{{0, radians(60)}, {}}};
    Cut cut;
    cut.roots = {{{}, {radians(0), radians(90)}}};
    cut.keep = {{0, 0.03}};
    style.parts[0].cuts = {cut};
    const SettledGroom groom = settled(style);
    ASSERT_EQ(groom.strands.size(), 2000U);
    for (std::size_t i = 0; i < groom.strands.size(); ++i) {
        const Vec3d root = groom.strands.strand(i)[0].as<double>();
        EXPECT_NEAR(skull.implicit(root), 0, 5e-3);
        const EllipsoidAngles at = headEllipsoid().angles(root);
        EXPECT_LE(at.theta, radians(60.01));
        if (std::abs(at.phi) < 1e-3 || std::abs(at.phi - radians(90)) < 1e-3) continue;
        const bool isCut = at.phi > 0 && at.phi < radians(90);
        EXPECT_NEAR(polylineLength(groom.strands.strand(i)), isCut ? 0.03 : 0.1, 1e-5);
    }
}

TEST(HairOnAHead, SaysWhatIsWrongWithTheHead) {
    Style style = onHead(10);
    style.headMesh = "no/such.obj";
    Result<SettledGroom> groom = settle(style);
    ASSERT_FALSE(groom.ok());
    EXPECT_EQ(groom.problems()[0].file, "no/such.obj");
    style = onHead(10);
    style.parts[0].scalp.groups = {"Scalp"};
    style.parts[0].scalp.groupsPlace = {"a.toml", 3, 1};
    groom = settle(style);
    ASSERT_FALSE(groom.ok());
    EXPECT_EQ(toString(groom.problems()[0]),
              "a.toml:3:1: error: groups: the head has no \"Scalp\", expected one of \"scalp\"");
}

}  // namespace
}  // namespace kushi
