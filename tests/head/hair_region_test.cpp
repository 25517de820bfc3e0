// SPDX-License-Identifier: Apache-2.0
#include "head/measure.h"

#include <algorithm>
#include <cmath>
#include <numbers>

#include <gtest/gtest.h>

namespace kushi {
namespace {

/// The default ellipsoid of design and paper, in centimetres.
const Ellipsoid ellipsoid = {.center = {}, .semiAxes = {10.5, 12.5, 8.5}, .rotateZ = radians(20)};

bool growsHair(EllipsoidAngles angles) {
    return std::ranges::any_of(hairRegion(),
                               [&](const AngleRange& r) { return r.contains(angles); });
}

bool inZone(std::string_view name, double theta, double phi) {
    return std::ranges::any_of(hairZone(name), [&](const AngleRange& r) {
        return r.contains({radians(theta), radians(phi)});
    });
}

/// The skin under a point of the ellipsoid, along the normal.
Vec3d skinBelow(EllipsoidAngles angles) {
    const Vec3d top = ellipsoid.point(angles);
    const Vec3d inwards = -ellipsoid.normal(top);
    return firstHit(top - inwards, inwards).value_or(Vec3d{});
}

TEST(MannequinHair, TheEllipsoidIsTheDefaultOne) {
    const Ellipsoid own = headEllipsoid();
    EXPECT_EQ(own.center, Vec3d{});
    EXPECT_NEAR(100 * own.semiAxes.x, 10.5, 1e-9);
    EXPECT_NEAR(100 * own.semiAxes.y, 12.5, 1e-9);
    EXPECT_NEAR(100 * own.semiAxes.z, 8.5, 1e-9);
    EXPECT_NEAR(degrees(own.rotateZ), 20, 1e-9);
}

// All of the head down to the chin in front and to the hairline behind, ears and nose included.
TEST(MannequinHair, TheEllipsoidEnclosesCraniumAndFace) {
    for (const Vec3f vertex : theHead().vertices) {
        const Vec3d p = inCm(vertex);
        const bool head = p.x > 2 ? p.y > -11 : p.y > -5;
        if (head) {
            EXPECT_LT(ellipsoid.implicit(p), 0.002) << p.x << ' ' << p.y << ' ' << p.z;
        }
    }
}

TEST(MannequinHair, TheSkinIsWithinOneAndAHalfCentimetresOfTheEllipsoidWhereHairGrows) {
    for (int theta = 1; theta < 110; theta += 6) {
        for (int phi = -180; phi <= 0; phi += 12) {
            const EllipsoidAngles at = {radians(theta), radians(phi)};
            if (!growsHair(at)) continue;
            const Vec3d top = ellipsoid.point(at);
            EXPECT_LT(length(skinBelow(at) - top), 1.5) << theta << ' ' << phi;
        }
    }
}

TEST(MannequinHair, GrowsFromForeheadToNapeAndNotOnFaceAndEars) {
    const auto grows = [](Vec3d cm) { return growsHair(ellipsoid.angles(cm)); };
    EXPECT_TRUE(grows({-4, 11, 0}));
    EXPECT_TRUE(grows({5.7, 8.8, 0}));
    EXPECT_FALSE(grows({7, 7.4, 0}));
    EXPECT_TRUE(grows({-8, -5, 0}));
    EXPECT_FALSE(grows({-7.7, -8, 0}));
    EXPECT_FALSE(grows({8.9, 0, 2}));
    for (const double side : {-1.0, 1.0}) {
        EXPECT_TRUE(grows({1.5, 1.5, 7 * side})) << "before the ear";
        EXPECT_TRUE(grows({-2.5, 3, 7.4 * side})) << "above the ear";
        EXPECT_TRUE(grows({-5, -2, 6.2 * side})) << "behind the ear";
        EXPECT_FALSE(grows({-2.5, -1, 7.5 * side})) << "ear";
        EXPECT_FALSE(grows({4.5, -2, 5.8 * side})) << "cheek";
    }
}

// The forehead from brows to hairline is six to seven centimetres high, measured along the skin.
TEST(MannequinHair, TheForeheadIsAsHighAsAForehead) {
    const double brows = 100 * landmarkHeight("brows").value();
    const double hairline = 100 * landmarkHeight("hairline").value();
    const auto skin = [&](double share) {
        const double y = brows + share * (hairline - brows);
        return firstHit({30, y, 1e-4}, {-1, 0, 0}).value_or(Vec3d{});
    };
    constexpr int pieces = 60;
    double arc = 0;
    for (int i = 0; i < pieces; ++i) {
        arc += length(skin((i + 1.0) / pieces) - skin(i / double{pieces}));
    }
    EXPECT_GT(arc, 6);
    EXPECT_LT(arc, 7.2);
    const double theta = degrees(ellipsoid.angles(skin(1)).theta);
    EXPECT_TRUE(growsHair({radians(theta - 2), 0}));
    EXPECT_FALSE(growsHair({radians(theta + 2), 0}));
}

TEST(MannequinHair, TheNapeIsTheLowestHairOnTheMiddleOfTheNeck) {
    double theta = 80;
    while (growsHair({radians(theta), -std::numbers::pi}))
        theta += 0.25;
    const Vec3d skin = skinBelow({radians(theta), -std::numbers::pi});
    EXPECT_NEAR(100 * landmarkHeight("nape").value(), skin.y, 0.3);
}

TEST(MannequinHair, RangesMayRunPastHalfATurn) {
    const AngleRange back = {0, 1, radians(150), radians(210)};
    EXPECT_TRUE(back.contains({0.5, radians(160)}));
    EXPECT_TRUE(back.contains({0.5, radians(-160)}));
    EXPECT_FALSE(back.contains({0.5, radians(-140)}));
    EXPECT_FALSE(back.contains({1.5, radians(160)}));
    const AngleRange all = {0, 1, radians(-180), radians(180)};
    EXPECT_TRUE(all.contains({0, radians(-180)}));
    EXPECT_TRUE(all.contains({1, radians(179)}));
}

TEST(MannequinHair, ZonesLieWhereTheirNamesSay) {
    EXPECT_EQ(hairZones().size(), 10U);
    EXPECT_TRUE(inZone("crown", 0, 0));
    EXPECT_TRUE(inZone("top", 45, 0));
    EXPECT_TRUE(inZone("front", 60, 0));
    EXPECT_TRUE(inZone("fringe", 60, 0));
    EXPECT_FALSE(inZone("fringe", 60, 80));
    EXPECT_TRUE(inZone("hairline", 58, 0));
    EXPECT_FALSE(inZone("hairline", 50, 0));
    EXPECT_FALSE(inZone("hairline", 63, 0));
    EXPECT_TRUE(inZone("hairline", 66, 50));
    EXPECT_TRUE(inZone("hairline", 66, -50));
    EXPECT_FALSE(inZone("hairline", 66, 90));
    EXPECT_TRUE(inZone("right", 80, 80));
    EXPECT_FALSE(inZone("right", 80, -80));
    EXPECT_TRUE(inZone("left", 80, -80));
    EXPECT_FALSE(inZone("left", 80, 80));
    EXPECT_TRUE(inZone("sides", 80, 80));
    EXPECT_TRUE(inZone("sides", 80, -80));
    EXPECT_TRUE(inZone("back", 60, -180));
    EXPECT_TRUE(inZone("nape", 100, -180));
    EXPECT_FALSE(inZone("nape", 60, -180));
    EXPECT_TRUE(hairZone("knee").empty());
}

// Every place where hair grows belongs to some zone, so that a style can reach all of the hair.
TEST(MannequinHair, TheZonesTogetherCoverTheHair) {
    for (int theta = 0; theta < 110; ++theta) {
        for (int phi = -180; phi < 180; ++phi) {
            if (!growsHair({radians(theta), radians(phi)})) continue;
            const bool reached = std::ranges::any_of(
                hairZones(), [&](const HairZone& zone) { return inZone(zone.name, theta, phi); });
            EXPECT_TRUE(reached) << theta << ' ' << phi;
        }
    }
}

// A scalp is some 600 to 700 square centimetres; on both sides alike, above the shoulders.
TEST(MannequinHair, TheScalpIsAsLargeAsAScalp) {
    const std::vector<std::uint8_t> flags = scalpTriangles(theHead());
    ASSERT_EQ(flags.size(), theHead().triangles.size());
    double right = 0;
    double left = 0;
    for (std::size_t i = 0; i < flags.size(); ++i) {
        if (flags[i] == 0) continue;
        const auto& [a, b, c] = theHead().triangles[i];
        const auto& v = theHead().vertices;
        const Vec3d middle = (inCm(v[a]) + inCm(v[b]) + inCm(v[c])) / 3.0;
        EXPECT_GT(middle.y, -8);
        (middle.z > 0 ? right : left) +=
            0.5 * length(cross(inCm(v[b]) - inCm(v[a]), inCm(v[c]) - inCm(v[a])));
    }
    EXPECT_NEAR(right, left, 0.001 * right);
    EXPECT_GT(right + left, 550);
    EXPECT_LT(right + left, 750);
}

}  // namespace
}  // namespace kushi
