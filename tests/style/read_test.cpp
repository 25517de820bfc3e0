// SPDX-License-Identifier: Apache-2.0
#include "style/keys.h"

#include <kushi/head.h>
#include <kushi/pigment.h>
#include <kushi/style.h>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

namespace kushi {
namespace {

constexpr double pi = std::numbers::pi;
constexpr double inf = std::numeric_limits<double>::infinity();

Style parsed(const std::string& text) {
    const auto style = parseStyle(text, "test.toml");
    if (style) return *style;
    for (const Problem& problem : style.problems())
        ADD_FAILURE() << toString(problem);
    return {};
}

const std::string smallest =
    "kushi = 1\n"
    "[scalp]\nellipsoid = { semi_axes = [10, 12, 8] }\nspacing = 0.5\n"
    "[hair]\nlength = 25\n";

Part partWith(const std::string& tables) {
    const Style style = parsed(smallest + tables);
    return style.parts.empty() ? Part{} : style.parts[0];
}

void expectNear(Vec3d actual, Vec3d expected) {
    EXPECT_NEAR(actual.x, expected.x, 1e-15);
    EXPECT_NEAR(actual.y, expected.y, 1e-15);
    EXPECT_NEAR(actual.z, expected.z, 1e-15);
}

void expectRange(Range actual, double low, double high) {
    EXPECT_DOUBLE_EQ(actual.low, low);
    EXPECT_DOUBLE_EQ(actual.high, high);
}

TEST(Style, OfTheFewestKeysHasTheDocumentedDefaults) {
    const Style style = parsed(smallest);
    EXPECT_EQ(style.name, "");
    EXPECT_EQ(style.seed, 1U);
    EXPECT_EQ(style.gravity, (Vec3d{0, -1, 0}));
    EXPECT_EQ(style.headMesh, "mannequin");
    EXPECT_TRUE(style.headCollides);
    EXPECT_EQ(style.headGap, 0);
    EXPECT_EQ(style.headFriction, 0);
    EXPECT_TRUE(style.colliders.empty());
    EXPECT_TRUE(style.contact.layers);
    EXPECT_EQ(style.contact.packing, std::nullopt);
    EXPECT_EQ(style.solver.method, Method::Cantilever);
    EXPECT_EQ(style.solver.segments, 24);
    EXPECT_EQ(style.solver.avoidanceSteps, 4);
    ASSERT_EQ(style.parts.size(), 1U);

    const Part& part = style.parts[0];
    EXPECT_EQ(part.name, "hair");
    EXPECT_TRUE(part.forces.empty());
    EXPECT_TRUE(part.cuts.empty());
    EXPECT_EQ(part.scalp.ellipsoid.center, (Vec3d{0, 0, 0}));
    EXPECT_EQ(part.scalp.ellipsoid.rotateZ, 0);
    EXPECT_EQ(part.scalp.jitter, 0.5);
    EXPECT_EQ(part.scalp.edge, 0);
    ASSERT_EQ(part.scalp.regions.size(), 1U);
    expectRange(part.scalp.regions[0].theta, -inf, inf);
    expectRange(part.scalp.regions[0].phi, -inf, inf);
    EXPECT_EQ(part.hair.lengthVariation, 0);
    EXPECT_EQ(part.hair.youngsModulus, 3.9e9);
    EXPECT_EQ(part.hair.diameter, 75e-6);
    EXPECT_EQ(part.hair.density, 1320);
    EXPECT_EQ(part.hair.flexuralRigidity, std::nullopt);
    EXPECT_EQ(part.hair.stiffness, 1);
    EXPECT_EQ(part.hair.growth, Growth::Normal);
    EXPECT_EQ(part.hair.lift, pi / 2);
    EXPECT_EQ(part.hair.lean.direction.vector, (Vec3d{0, -1, 0}));
    EXPECT_FALSE(part.hair.lean.whorl);
    EXPECT_EQ(part.scalp.surface, ScalpSurface::Ellipsoid);
    EXPECT_TRUE(part.scalp.groups.empty());
    EXPECT_FALSE(part.scalp.mask);
    EXPECT_EQ(part.hair.color, (Rgb{0.06F, 0.032F, 0.02F}));
    EXPECT_EQ(part.hair.variation, 0.12);
}

TEST(Style, TopKeysAreRead) {
    const Style style =
        parsed("name = \"bob \xE6\xAB\x9B\"\nseed = 9223372036854775807\ngravity = [0, -1.5, 2]\n" +
               smallest + "[head]\nmesh = \"none\"\n" +
               "[solver]\nmethod = \"cantilever\"\nsegments = 256\navoidance_steps = 16\n");
    EXPECT_EQ(style.name, "bob \xE6\xAB\x9B");
    EXPECT_EQ(style.seed, 9223372036854775807U);
    EXPECT_EQ(style.gravity, (Vec3d{0, -1.5, 2}));
    EXPECT_EQ(style.headMesh, "none");
    EXPECT_EQ(style.solver.segments, 256);
    EXPECT_EQ(style.solver.avoidanceSteps, 16);
}

TEST(Style, ScalpIsConvertedToMetresAndRadians) {
    const Style style = parsed(
        "kushi = 1\n[[part]]\nname = \"tail\"\n[part.scalp]\n"
        "ellipsoid = { center = [1, -2.5, 3], semi_axes = [10.5, 12.5, 8.5], rotate_z = 20 }\n"
        "count = 50_000\njitter = 0.25\nedge = 0.75\n"
        "regions = [{ theta = [0, 90] }, { theta = [45, 180], phi = [90, 270] }]\n"
        "[part.hair]\nlength = 25\n");
    ASSERT_EQ(style.parts.size(), 1U);
    EXPECT_EQ(style.parts[0].name, "tail");
    const Scalp& scalp = style.parts[0].scalp;
    EXPECT_EQ(scalp.ellipsoid.center, (Vec3d{0.01, -0.025, 0.03}));
    EXPECT_EQ(scalp.ellipsoid.semiAxes, (Vec3d{0.105, 0.125, 0.085}));
    EXPECT_DOUBLE_EQ(scalp.ellipsoid.rotateZ, pi / 9);
    EXPECT_EQ(scalp.spacing, std::nullopt);
    EXPECT_EQ(scalp.count, 50'000);
    EXPECT_EQ(scalp.jitter, 0.25);
    EXPECT_DOUBLE_EQ(scalp.edge, 0.0075);
    ASSERT_EQ(scalp.regions.size(), 2U);
    expectRange(scalp.regions[0].theta, 0, pi / 2);
    expectRange(scalp.regions[0].phi, -inf, inf);
    expectRange(scalp.regions[1].theta, pi / 4, pi);
    expectRange(scalp.regions[1].phi, pi / 2, 3 * pi / 2);
}

TEST(Style, HairIsConvertedToSi) {
    const Hair hair = partWith(
                          "length_variation = 0.05\nyoungs_modulus = 4\ndiameter = 81\n"
                          "density = 1.3\nflexural_rigidity = 7.8e-9\nstiffness = 2\n"
                          "growth = \"radial\"\n")
                          .hair;
    EXPECT_EQ(hair.length, 0.25);
    EXPECT_EQ(hair.lengthVariation, 0.05);
    EXPECT_EQ(hair.youngsModulus, 4e9);
    EXPECT_EQ(hair.diameter, 81e-6);
    EXPECT_DOUBLE_EQ(hair.density, 1300);
    EXPECT_EQ(hair.flexuralRigidity, 7.8e-9);
    EXPECT_EQ(hair.stiffness, 2);
    EXPECT_EQ(hair.growth, Growth::Radial);
}

TEST(Style, HairMayGrowFromTheHead) {
    const auto style = parseStyle(
        "kushi = 1\n[scalp]\nellipsoid = { semi_axes = [10, 12, 8] }\nspacing = 0.5\n"
        "surface = \"head\"\n  groups = [\"Scalp\", \"my skin\"]\n    mask = \"heads/a.png\"\n"
        "[hair]\nlength = 25\n",
        "styles/a.toml");
    ASSERT_TRUE(style.ok()) << toString(style.problems()[0]);
    const Scalp& scalp = style->parts[0].scalp;
    EXPECT_EQ(scalp.surface, ScalpSurface::Head);
    EXPECT_EQ(scalp.groups, (std::vector<std::string>{"Scalp", "my skin"}));
    EXPECT_EQ(scalp.mask, "styles/heads/a.png");
    EXPECT_EQ(scalp.surfacePlace.line, 5);
    EXPECT_EQ(scalp.groupsPlace.line, 6);
    EXPECT_EQ(scalp.groupsPlace.column, 3);
    EXPECT_EQ(scalp.maskPlace.line, 7);
    EXPECT_EQ(scalp.maskPlace.column, 5);
    EXPECT_EQ(scalp.maskPlace.file, "styles/a.toml");
}

TEST(Style, HairLeansWhereItIsTold) {
    Hair hair = partWith("lift = 30\n").hair;
    EXPECT_DOUBLE_EQ(hair.lift, pi / 6);
    EXPECT_EQ(hair.lean.direction.vector, (Vec3d{0, -1, 0}));
    hair = partWith("lift = 0\ntowards = [0, 3, -4]\n").hair;
    EXPECT_EQ(hair.lift, 0);
    expectNear(hair.lean.direction.vector, {0, 0.6, -0.8});
    EXPECT_FALSE(hair.lean.reversed);
    hair = partWith("lift = 10\ntowards = \"in\"\n").hair;
    EXPECT_TRUE(hair.lean.direction.radial);
    EXPECT_TRUE(hair.lean.reversed);
    hair = partWith("lift = 10\nwhorl = { theta = 9, phi = 180, turn = -45 }\n").hair;
    ASSERT_TRUE(hair.lean.whorl);
    EXPECT_DOUBLE_EQ(hair.lean.whorl->at.theta, pi / 20);
    EXPECT_DOUBLE_EQ(hair.lean.whorl->at.phi, pi);
    EXPECT_DOUBLE_EQ(hair.lean.whorl->turn, -pi / 4);
}

TEST(Style, ClumpsAndFlyawaysAreNumbersOrTables) {
    Hair hair = partWith("").hair;
    EXPECT_EQ(hair.clump.amount, 0);
    EXPECT_EQ(hair.flyaway.share, 0);
    hair = partWith("clump = 0.3\nflyaway = 0.015\n").hair;
    EXPECT_EQ(hair.clump.amount, 0.3);
    EXPECT_EQ(hair.clump.size, 0.008);
    EXPECT_EQ(hair.clump.variation, 0.5);
    EXPECT_EQ(hair.clump.from, 0.1);
    EXPECT_EQ(hair.flyaway.share, 0.015);
    EXPECT_EQ(hair.flyaway.distance, 0.01);
    hair = partWith(
               "clump = { amount = 0.9, size = 1.5, variation = 0.2, from = 0.4 }\n"
               "flyaway = { share = 0.1, distance = 2 }\n")
               .hair;
    EXPECT_EQ(hair.clump.amount, 0.9);
    EXPECT_EQ(hair.clump.size, 0.015);
    EXPECT_EQ(hair.clump.variation, 0.2);
    EXPECT_EQ(hair.clump.from, 0.4);
    EXPECT_EQ(hair.flyaway.share, 0.1);
    EXPECT_EQ(hair.flyaway.distance, 0.02);
}

TEST(Style, HairTypesAreDiametersThatADiameterReplaces) {
    EXPECT_EQ(partWith("type = \"fine\"\n").hair.diameter, 60e-6);
    EXPECT_EQ(partWith("type = \"medium\"\n").hair.diameter, 75e-6);
    EXPECT_EQ(partWith("type = \"coarse\"\n").hair.diameter, 95e-6);
    EXPECT_EQ(partWith("diameter = 50\ntype = \"coarse\"\n").hair.diameter, 50e-6);
}

// By the transfer function of IEC 61966-2-1, worked out by hand.
TEST(Style, ColorsArePickedInSrgbAndKeptInLinearLight) {
    const Hair hair = partWith("color = [0.5, 0.04, 1]\nvariation = 0.25\n").hair;
    EXPECT_NEAR(hair.color.r, 0.21404114, 1e-7);
    EXPECT_NEAR(hair.color.g, 0.00309598, 1e-8);
    EXPECT_EQ(hair.color.b, 1);
    EXPECT_EQ(hair.variation, 0.25);
    EXPECT_EQ(partWith("color = [0, 0.0, 0]\n").hair.color, (Rgb{}));
}

TEST(Style, PigmentIsTheColourOfAHeadOfIt) {
    const auto pigment = [](const std::string& melanin) {
        return partWith("color = { melanin = " + melanin + " }\n").hair.color;
    };
    const Rgb brown = pigment("1.3");
    const Rgb back = absorptionOfColor(brown, 0.3);
    EXPECT_NEAR(back.r, 0.5447, 1e-3);
    EXPECT_NEAR(back.g, 0.9061, 1e-3);
    EXPECT_NEAR(back.b, 1.7810, 2e-3);
    EXPECT_GT(pigment("0.3").g, brown.g);
    EXPECT_GT(pigment("4").r, pigment("8").r);
    EXPECT_GT(absorptionOfColor(pigment("8"), 0.3).r, absorptionOfColor(pigment("4"), 0.3).r);
    const Rgb red = pigment("1.3, redness = 1");
    EXPECT_GT(red.r / red.g, brown.r / brown.g);
    EXPECT_EQ(pigment("0"), (Rgb{1, 1, 1}));
}

TEST(Style, HairHasGreyStrandsRegrowthAndTips) {
    Hair hair = partWith("").hair;
    EXPECT_EQ(hair.grey.share, 0);
    EXPECT_FALSE(hair.regrowth);
    EXPECT_FALSE(hair.tips);
    hair = partWith(
               "grey = 0.3\nregrowth = { color = \"black\", length = 3 }\n"
               "tips = { color = { melanin = 0 }, length = 10 }\n")
               .hair;
    EXPECT_EQ(hair.grey.share, 0.3);
    EXPECT_EQ(hair.grey.color, Grey().color);
    ASSERT_TRUE(hair.regrowth && hair.tips);
    EXPECT_EQ(hair.regrowth->color, partWith("color = \"black\"\n").hair.color);
    EXPECT_EQ(hair.regrowth->length, 0.03);
    EXPECT_NEAR(hair.regrowth->blend, 0.01, 1e-12);
    EXPECT_EQ(hair.tips->color, (Rgb{1, 1, 1}));
    EXPECT_EQ(hair.tips->length, 0.1);
    EXPECT_EQ(hair.tips->blend, 0.1);
    hair = partWith(
               "grey = { share = 0.5, color = [1, 1, 1] }\n"
               "tips = { color = \"red\", length = 8, blend = 2 }\n")
               .hair;
    EXPECT_EQ(hair.grey.share, 0.5);
    EXPECT_EQ(hair.grey.color, (Rgb{1, 1, 1}));
    EXPECT_EQ(hair.tips->blend, 0.02);
}

TEST(Style, HighlightsAreRead) {
    const Part part = partWith(
        "[[highlight]]\ncolor = \"blond\"\n[[highlight]]\ncolor = [1, 1, 1]\nshare = 0.1\n"
        "roots = { theta = [0, 90] }\nfoil = 0.5\nfrom = 2\nto = 20\nblend = 0\n");
    ASSERT_EQ(part.highlights.size(), 2U);
    EXPECT_EQ(part.highlights[0].color, partWith("color = \"blond\"\n").hair.color);
    EXPECT_EQ(part.highlights[0].share, 0.2);
    EXPECT_EQ(part.highlights[0].foil, 0);
    EXPECT_EQ(part.highlights[0].from, 0);
    EXPECT_EQ(part.highlights[0].to, inf);
    EXPECT_EQ(part.highlights[0].blend, 0.01);
    const Highlight& second = part.highlights[1];
    EXPECT_EQ(second.color, (Rgb{1, 1, 1}));
    EXPECT_EQ(second.share, 0.1);
    ASSERT_EQ(second.roots.size(), 1U);
    expectRange(second.roots[0].theta, 0, pi / 2);
    EXPECT_EQ(second.foil, 0.005);
    EXPECT_EQ(second.from, 0.02);
    EXPECT_EQ(second.to, 0.2);
    EXPECT_EQ(second.blend, 0);
}

TEST(Style, NamedColorsAreInOrderOfTheirLightness) {
    EXPECT_EQ(partWith("color = \"dark brown\"\n").hair.color, Hair().color);
    float last = 0;
    for (const std::string name : {"black", "dark brown", "auburn", "brown", "light brown",
                                   "dark blond", "grey", "blond", "platinum", "white"}) {
        const Rgb color = partWith("color = \"" + name + "\"\n").hair.color;
        const float luminance = 0.2126F * color.r + 0.7152F * color.g + 0.0722F * color.b;
        EXPECT_GT(luminance, last) << name;
        EXPECT_LT(luminance, 1) << name;
        last = luminance;
    }
    const Rgb red = partWith("color = \"red\"\n").hair.color;
    EXPECT_GT(red.r, 3 * red.g);
    EXPECT_GT(red.g, red.b);
}

// The heights that docs/head.md gives.
TEST(Style, LandmarksStandForTheirHeights) {
    const Part part = partWith(
        "[[force]]\ndirection = \"in\"\nwithin = { y = [\"shoulders\", \"crown\"] }\n"
        "[[force]]\ndirection = \"in\"\nwithin = { y = [-inf, \"brows\"] }\n"
        "[[cut]]\nbelow = \"chin\"\n[[cut]]\nkeep = [[\"nape\", 2], [0, 4], [\"hairline\", 6]]\n");
    ASSERT_EQ(part.forces.size(), 2U);
    expectRange(part.forces[0].within.y, -0.193, 0.1135);
    expectRange(part.forces[1].within.y, -inf, 0.022);
    ASSERT_EQ(part.cuts.size(), 2U);
    EXPECT_EQ(part.cuts[0].below, -0.109);
    ASSERT_EQ(part.cuts[1].keep.size(), 3U);
    EXPECT_EQ(part.cuts[1].keep[0].y, -0.066);
    EXPECT_EQ(part.cuts[1].keep[2].y, 0.083);
}

TEST(Style, LandmarksAreTheBuiltInHeadsEvenWithoutAHead) {
    const Part part = partWith("[[cut]]\nbelow = \"brows\"\n[head]\nmesh = \"none\"\n");
    ASSERT_EQ(part.cuts.size(), 1U);
    EXPECT_EQ(part.cuts[0].below, 0.022);
}

// Wherever [head] stands in the file.
TEST(Style, AHeadMayHaveHeightsOfItsOwn) {
    const std::string head = "[head]\nlandmarks = { brows = 3.5, chin = -12 }\n";
    const std::string cuts =
        "[[cut]]\nbelow = \"brows\"\n[[cut]]\nbelow = \"nose\"\n"
        "[[cut]]\nkeep = [[\"chin\", 2], [\"brows\", 3]]\n"
        "[[force]]\ndirection = \"in\"\nwithin = { y = [\"chin\", inf] }\n";
    for (const std::string& tables : {head + cuts, cuts + head}) {
        const Part part = partWith(tables);
        ASSERT_EQ(part.cuts.size(), 3U);
        EXPECT_EQ(part.cuts[0].below, 0.035);
        EXPECT_EQ(part.cuts[1].below, -0.033);
        ASSERT_EQ(part.cuts[2].keep.size(), 2U);
        EXPECT_EQ(part.cuts[2].keep[0].y, -0.12);
        ASSERT_EQ(part.forces.size(), 1U);
        expectRange(part.forces[0].within.y, -0.12, inf);
    }
}

TEST(Style, AHeadFromAFileIsFoundFromTheStyle) {
    const auto headIn = [](const std::string& file, const std::string& lines) {
        const auto style = parseStyle(smallest + "[head]\n" + lines, file);
        EXPECT_TRUE(style.ok()) << toString(style.problems()[0]);
        return style ? *style : Style{};
    };
    EXPECT_EQ(headIn("styles/a.toml", "mesh = \"heads/Me.OBJ\"\n").headMesh, "styles/heads/Me.OBJ");
    EXPECT_EQ(headIn("a.toml", "mesh = \"me.stl\"\n").headMesh, "me.stl");
    EXPECT_EQ(headIn("styles/a.toml", "mesh = \"/heads/me.glb\"\n").headMesh, "/heads/me.glb");

    const MeshPlacement usual = headIn("a.toml", "mesh = \"me.ply\"\n").headPlacement;
    EXPECT_EQ(usual.unit, std::nullopt);
    EXPECT_EQ(usual.up, (Vec3d{0, 1, 0}));
    EXPECT_EQ(usual.front, (Vec3d{0, 0, 1}));
    EXPECT_EQ(usual.origin, MeshOrigin::Crown);
    EXPECT_EQ(usual.offset, Vec3d{});

    const MeshPlacement placed =
        headIn("a.toml",
               "front = \"-y\"\nup = \"z\"\nunit = \"in\"\norigin = \"file\"\n"
               "offset = [0, -1.5, 2]\nmesh = \"me.ply\"\n")
            .headPlacement;
    EXPECT_EQ(placed.unit, 0.0254);
    EXPECT_EQ(placed.up, (Vec3d{0, 0, 1}));
    EXPECT_EQ(placed.front, (Vec3d{0, -1, 0}));
    EXPECT_EQ(placed.origin, MeshOrigin::File);
    EXPECT_EQ(placed.offset, (Vec3d{0, -0.015, 0.02}));
    EXPECT_EQ(headIn("a", "mesh = \"a.ply\"\nunit = 12\n").headPlacement.unit, 0.12);
}

TEST(Style, SaysHowHairKeepsOffTheHead) {
    const Style style = parsed(smallest + "[head]\ncollide = false\ngap = -0.25\nfriction = 0.4\n");
    EXPECT_FALSE(style.headCollides);
    EXPECT_EQ(style.headGap, -0.0025);
    EXPECT_EQ(style.headFriction, 0.4);
}

TEST(Style, CollidersAreReadInOrderAndFoundFromTheStyle) {
    const auto style = parseStyle(
        smallest +
            "[[collider]]\nmesh = \"bodies/me.OBJ\"\n"
            "[[collider]]\nmesh = \"hat.stl\"\nunit = \"mm\"\nup = \"z\"\nfront = \"-y\"\n"
            "origin = \"crown\"\noffset = [0, 1, -2]\ngap = 5\nfriction = 2\n"
            "[[collider]]\nmesh = \"mannequin\"\ngap = 0.5\n",
        "styles/a.toml");
    ASSERT_TRUE(style.ok()) << toString(style.problems()[0]);
    ASSERT_EQ(style->colliders.size(), 3U);

    const Collider& body = style->colliders[0];
    EXPECT_EQ(body.mesh, "styles/bodies/me.OBJ");
    EXPECT_EQ(body.placement.unit, std::nullopt);
    EXPECT_EQ(body.placement.up, (Vec3d{0, 1, 0}));
    EXPECT_EQ(body.placement.front, (Vec3d{0, 0, 1}));
    EXPECT_EQ(body.placement.origin, MeshOrigin::File);
    EXPECT_EQ(body.placement.offset, Vec3d{});
    EXPECT_EQ(body.gap, 0);
    EXPECT_EQ(body.friction, 0);

    const Collider& hat = style->colliders[1];
    EXPECT_EQ(hat.mesh, "styles/hat.stl");
    EXPECT_EQ(hat.placement.unit, 0.001);
    EXPECT_EQ(hat.placement.up, (Vec3d{0, 0, 1}));
    EXPECT_EQ(hat.placement.front, (Vec3d{0, -1, 0}));
    EXPECT_EQ(hat.placement.origin, MeshOrigin::Crown);
    EXPECT_EQ(hat.placement.offset, (Vec3d{0, 0.01, -0.02}));
    EXPECT_EQ(hat.gap, 0.05);
    EXPECT_EQ(hat.friction, 2);

    EXPECT_EQ(style->colliders[2].mesh, "mannequin");
    EXPECT_EQ(style->colliders[2].gap, 0.005);
}

TEST(Style, HairAgainstHairIsRead) {
    const Contact contact = parsed(smallest + "[contact]\nlayers = false\npacking = 0.9\n").contact;
    EXPECT_FALSE(contact.layers);
    EXPECT_EQ(contact.packing, 0.9);
}

TEST(Style, ZonesStandForTheirRanges) {
    const Part part = partWith(
        "[[force]]\ndirection = \"in\"\nroots = { where = \"fringe\" }\n"
        "[[cut]]\nbelow = 0\nroots = { where = \"sides\" }\n");
    ASSERT_EQ(part.forces.size(), 1U);
    ASSERT_EQ(part.forces[0].roots.size(), 1U);
    expectRange(part.forces[0].roots[0].theta, radians(46), radians(70));
    expectRange(part.forces[0].roots[0].phi, radians(-42), radians(42));
    ASSERT_EQ(part.cuts.size(), 1U);
    ASSERT_EQ(part.cuts[0].roots.size(), 2U);
    expectRange(part.cuts[0].roots[0].phi, radians(-112), radians(-60));
    expectRange(part.cuts[0].roots[1].phi, radians(60), radians(112));
}

TEST(Style, EveryZoneOfTheHeadCanBeNamed) {
    for (const HairZone& zone : hairZones()) {
        const Part part =
            partWith("[[cut]]\nbelow = 0\nroots.where = \"" + std::string(zone.name) + "\"\n");
        ASSERT_EQ(part.cuts.size(), 1U);
        ASSERT_EQ(part.cuts[0].roots.size(), zone.ranges.size()) << zone.name;
        for (std::size_t i = 0; i < zone.ranges.size(); ++i) {
            const RootRange& range = part.cuts[0].roots[i];
            expectRange(range.theta, zone.ranges[i].thetaLow, zone.ranges[i].thetaHigh);
            expectRange(range.phi, zone.ranges[i].phiLow, zone.ranges[i].phiHigh);
        }
    }
}

TEST(Style, RegionsMayBeTheNaturalHairlineAndMore) {
    const Style style = parsed(
        "kushi = 1\n[scalp]\nellipsoid = { semi_axes = [10.5, 12.5, 8.5], rotate_z = 20 }\n"
        "count = 100\nregions = [{ where = \"scalp\" }, { theta = [100, 120] }]\n"
        "[hair]\nlength = 25\n");
    ASSERT_EQ(style.parts.size(), 1U);
    const RootRanges& regions = style.parts[0].scalp.regions;
    ASSERT_EQ(regions.size(), hairRegion().size() + 1);
    expectRange(regions.front().theta, hairRegion()[0].thetaLow, hairRegion()[0].thetaHigh);
    expectRange(regions.back().theta, radians(100), radians(120));
}

TEST(Style, ForcesAreReadInOrder) {
    const Part part = partWith(
        "[[force]]\nroots = { theta = [0, 90], phi = [-180, 180] }\n"
        "within = { x = [-inf, 5], y = [3.5, inf], z = [0, +inf] }\n"
        "direction = \"z\"\nmagnitude = -0.5\nfalloff = { degrees = 18, cm = 1 }\n"
        "[[force]]\ndirection = \"r\"\n");
    ASSERT_EQ(part.forces.size(), 2U);
    const Force& force = part.forces[0];
    ASSERT_EQ(force.roots.size(), 1U);
    expectRange(force.roots[0].theta, 0, pi / 2);
    expectRange(force.roots[0].phi, -pi, pi);
    expectRange(force.within.x, -inf, 0.05);
    expectRange(force.within.y, 0.035, inf);
    expectRange(force.within.z, 0, inf);
    EXPECT_FALSE(force.direction.radial);
    EXPECT_EQ(force.direction.vector, (Vec3d{0, 0, 1}));
    EXPECT_EQ(force.magnitude, -0.5);
    EXPECT_DOUBLE_EQ(force.falloff.angle, pi / 10);
    EXPECT_EQ(force.falloff.distance, 0.01);

    const Force& plain = part.forces[1];
    EXPECT_TRUE(plain.direction.radial);
    EXPECT_EQ(plain.magnitude, 1);
    EXPECT_EQ(plain.falloff.angle, 0);
    EXPECT_EQ(plain.falloff.distance, 0);
    expectRange(plain.within.y, -inf, inf);
    ASSERT_EQ(plain.roots.size(), 1U);
    expectRange(plain.roots[0].theta, -inf, inf);
}

TEST(Style, NamedDirectionsAreThoseOfTheFace) {
    const auto directed = [](const std::string& name) {
        const Part part = partWith("[[force]]\nmagnitude = 0.25\ndirection = \"" + name + "\"\n");
        return part.forces.empty() ? Force{} : part.forces[0];
    };
    expectNear(directed("x").direction.vector, {1, 0, 0});
    expectNear(directed("y").direction.vector, {0, 1, 0});
    expectNear(directed("z").direction.vector, {0, 0, 1});
    expectNear(directed("front").direction.vector, {1, 0, 0});
    expectNear(directed("back").direction.vector, {-1, 0, 0});
    expectNear(directed("left").direction.vector, {0, 0, -1});
    expectNear(directed("right").direction.vector, {0, 0, 1});
    expectNear(directed("up").direction.vector, {0, 1, 0});
    expectNear(directed("down").direction.vector, {0, -1, 0});
    for (const char* name : {"r", "out"}) {
        EXPECT_TRUE(directed(name).direction.radial);
        EXPECT_EQ(directed(name).magnitude, 0.25);
    }
    EXPECT_TRUE(directed("in").direction.radial);
    EXPECT_EQ(directed("in").magnitude, -0.25);
    EXPECT_EQ(directed("left").magnitude, 0.25);
}

TEST(Style, VectorDirectionsAreNormalised) {
    const Part part = partWith(
        "[[force]]\ndirection = [0, 3, -4]\n"
        "[[force]]\ndirection = [1e-200, 0.0, 0]\n");
    ASSERT_EQ(part.forces.size(), 2U);
    expectNear(part.forces[0].direction.vector, {0, 0.6, -0.8});
    expectNear(part.forces[1].direction.vector, {1, 0, 0});
}

TEST(Style, CutsAreReadInOrder) {
    const Part part = partWith(
        "[[cut]]\nroots = { theta = [0, 60], phi = [-60, 60] }\nbelow = -3.5\nmode = \"hide\"\n"
        "[[cut]]\nkeep = [[-4, 2.0], [8, 6], [9.5, 0]]\nmode = \"settle\"\n"
        "falloff = { degrees = 18, cm = 1 }\n"
        "[[cut]]\nbelow = 0\n");
    ASSERT_EQ(part.cuts.size(), 3U);
    expectRange(part.cuts[0].roots.at(0).theta, 0, pi / 3);
    EXPECT_EQ(part.cuts[0].below, -0.035);
    EXPECT_TRUE(part.cuts[0].keep.empty());
    EXPECT_EQ(part.cuts[0].mode, CutMode::Hide);
    EXPECT_EQ(part.cuts[0].falloff.angle, 0);
    EXPECT_EQ(part.cuts[0].falloff.distance, 0);
    EXPECT_DOUBLE_EQ(part.cuts[1].falloff.angle, pi / 10);
    EXPECT_EQ(part.cuts[1].falloff.distance, 0.01);

    EXPECT_EQ(part.cuts[1].below, std::nullopt);
    ASSERT_EQ(part.cuts[1].keep.size(), 3U);
    EXPECT_EQ(part.cuts[1].keep[0].y, -0.04);
    EXPECT_EQ(part.cuts[1].keep[0].length, 0.02);
    EXPECT_EQ(part.cuts[1].keep[1].y, 0.08);
    EXPECT_EQ(part.cuts[1].keep[2].length, 0);
    EXPECT_EQ(part.cuts[1].mode, CutMode::Settle);
    EXPECT_EQ(part.cuts[2].mode, CutMode::Settle);
}

TEST(Style, MayHaveSeveralPartsWithNamesOfTheirOwn) {
    const std::string body =
        "[part.scalp]\nellipsoid = { semi_axes = [10, 12, 8] }\ncount = 5\n[part.hair]\nlength = ";
    const Style style = parsed("kushi = 1\n[[part]]\n" + body + "10\n[[part]]\n" + body +
                               "20\n[[part]]\nname = \"tail\"\n" + body + "30\n");
    ASSERT_EQ(style.parts.size(), 3U);
    EXPECT_EQ(style.parts[0].name, "hair");
    EXPECT_EQ(style.parts[1].name, "hair 2");
    EXPECT_EQ(style.parts[2].name, "tail");
    EXPECT_DOUBLE_EQ(style.parts[2].hair.length, 0.3);
}

TEST(Style, MayBeWrittenInAnyOfTomlsWays) {
    const Style style = parsed(
        "kushi = 0x1\nscalp.ellipsoid.semi_axes = [ 1_0, # front\n 12.0, 8e0,\n]\r\n"
        "scalp.\"count\" = 5 # few\nhair = { length = 25, type = 'fine' }\n"
        "force = [{ direction = 'z' }]\ncut = []\n");
    ASSERT_EQ(style.parts.size(), 1U);
    EXPECT_EQ(style.parts[0].scalp.ellipsoid.semiAxes, (Vec3d{0.1, 0.12, 0.08}));
    EXPECT_EQ(style.parts[0].scalp.count, 5);
    EXPECT_EQ(style.parts[0].hair.diameter, 60e-6);
    EXPECT_EQ(style.parts[0].forces.size(), 1U);
}

TEST(Style, RangesAreClosedAtBothEnds) {
    for (const char* line : {"length = 0.1", "length = 300"}) {
        std::string text = smallest;
        text.replace(text.find("length = 25"), 11, line);
        EXPECT_TRUE(parseStyle(text, "f")) << line;
    }
    EXPECT_TRUE(parseStyle(smallest + "[[cut]]\nbelow = 1\nroots = { phi = [-360, 0] }\n", "f"));
    EXPECT_TRUE(parseStyle(smallest + "[[cut]]\nbelow = 1\nroots = { phi = [0, 360] }\n", "f"));
}

// The example of the contract, as far as this version goes.
TEST(Style, ThePapersExampleIsRead) {
    const Style style = parsed(R"(
kushi = 1                          # format version
name  = "bob"
seed  = 1992
gravity = [0, -1, 0]               # times the earth's

[head]
mesh = "mannequin"                 # built in

[solver]                           # how well, not what
method = "cantilever"
segments = 24
avoidance_steps = 4

[[part]]
name = "hair"

[part.scalp]
ellipsoid = { center = [0, 0, 0], semi_axes = [10.5, 12.5, 8.5], rotate_z = 20 }   # cm, degrees
spacing = 0.13                     # cm between follicles
jitter  = 0.5
regions = [ { theta = [0, 100], phi = [-180, 180] } ]

[part.hair]
type = "medium"
length = 25.0                      # cm
length_variation = 0.05
youngs_modulus = 3.9               # GPa
diameter = 75                      # micrometres
density = 1.32                     # g/cm3

[[part.force]]
roots  = { theta = [0, 90], phi = [-180, 180] }
within = { y = [3.5, inf], z = [0, inf] }
direction = "z"
magnitude = 1.0

[[part.cut]]
roots = { theta = [0, 60], phi = [-60, 60] }
below = 3.5
mode = "settle"
)");
    EXPECT_EQ(style.name, "bob");
    EXPECT_EQ(style.seed, 1992U);
    ASSERT_EQ(style.parts.size(), 1U);
    const Part& part = style.parts[0];
    EXPECT_EQ(part.scalp.ellipsoid.semiAxes, (Vec3d{0.105, 0.125, 0.085}));
    EXPECT_DOUBLE_EQ(part.scalp.ellipsoid.rotateZ, 0.3490658503988659);
    EXPECT_EQ(part.scalp.spacing, 0.0013);
    expectRange(part.scalp.regions.at(0).theta, 0, 1.7453292519943295);
    EXPECT_EQ(part.hair.length, 0.25);
    EXPECT_EQ(part.hair.diameter, 75e-6);
    EXPECT_DOUBLE_EQ(part.hair.density, 1320);
    ASSERT_EQ(part.forces.size(), 1U);
    expectRange(part.forces[0].within.y, 0.035, inf);
    EXPECT_EQ(part.forces[0].magnitude, 1);
    ASSERT_EQ(part.cuts.size(), 1U);
    EXPECT_EQ(part.cuts[0].below, 0.035);
    EXPECT_EQ(part.cuts[0].mode, CutMode::Settle);
}

// No key may be known and then not looked at: a date fits none, so each must complain.
TEST(Style, EveryKnownKeyIsRead) {
    const std::pair<const TableKeys*, std::string> places[] = {
        {&tables::top, ""},
        {&tables::head, "[head]\n"},
        {&tables::landmarks, "[head.landmarks]\n"},
        {&tables::collider, "[[collider]]\n"},
        {&tables::contact, "[contact]\n"},
        {&tables::solver, "[solver]\n"},
        {&tables::part, "[[part]]\n"},
        {&tables::scalp, "[scalp]\n"},
        {&tables::ellipsoid, "[scalp.ellipsoid]\n"},
        {&tables::regions, "[[scalp.regions]]\n"},
        {&tables::groom, "[groom]\n"},
        {&tables::hair, "[hair]\n"},
        {&tables::curl, "[hair.curl]\n"},
        {&tables::whorl, "[hair.whorl]\n"},
        {&tables::wave, "[hair.wave]\n"},
        {&tables::clump, "[hair.clump]\n"},
        {&tables::flyaway, "[hair.flyaway]\n"},
        {&tables::grey, "[hair.grey]\n"},
        {&tables::regrowth, "[hair.regrowth]\n"},
        {&tables::tips, "[hair.tips]\n"},
        {&tables::color, "[hair.color]\n"},
        {&tables::highlight, "[[highlight]]\n"},
        {&tables::force, "[[force]]\n"},
        {&tables::cut, "[[cut]]\n"},
        {&tables::tie, "[[tie]]\n"},
        {&tables::roots, "[[cut]]\n[cut.roots]\n"},
        {&tables::within, "[[force]]\n[force.within]\n"},
        {&tables::falloff, "[[force]]\n[force.falloff]\n"},
    };
    EXPECT_EQ(std::size(places), std::size(tables::all));
    for (const auto& [table, header] : places) {
        for (const std::string_view key : table->keys()) {
            const auto style = parseStyle(header + std::string(key) + " = 1979-05-27\n", "f");
            ASSERT_FALSE(style) << key;
            EXPECT_THAT(style.problems(),
                        testing::Contains(testing::Field(
                            &Problem::message,
                            testing::StartsWith(std::string(key) + ": found the date 1979-05-27"))))
                << table->label;
        }
    }
}

Style read(const std::string& text) {
    const auto style = parseStyle("kushi = 1\n" + text, "styles/a.toml");
    EXPECT_TRUE(style) << toString(style.problems()[0]);
    return style ? *style : Style();
}

const std::string atRest = "[solver]\nmethod = \"equilibrium\"\n";

TEST(ReadStyle, FindsAGroomBesideTheStyle) {
    const Style style = read(atRest + "[[part]]\n  groom = \"scan.HAIR\"\n");
    const Part& part = style.parts.at(0);
    ASSERT_TRUE(part.groom);
    EXPECT_EQ(part.groom->path, "styles/scan.HAIR");
    EXPECT_EQ(part.groom->place.file, "styles/a.toml");
    EXPECT_EQ(part.groom->place.line, 5);
    EXPECT_EQ(part.groom->place.column, 3);
    EXPECT_FALSE(part.groom->placement.unit);
    EXPECT_EQ(part.groom->placement.up, (Vec3d{0, 1, 0}));
    EXPECT_EQ(part.groom->placement.front, (Vec3d{1, 0, 0}));
    EXPECT_EQ(part.hair.set, 1);
    EXPECT_EQ(part.scalp.ellipsoid.semiAxes, headEllipsoid().semiAxes);
    EXPECT_EQ(part.scalp.ellipsoid.rotateZ, headEllipsoid().rotateZ);
}

TEST(ReadStyle, PutsAGroomInItsPlace) {
    const Style style = read(
        "groom = { file = \"/scans/me.ply\", unit = \"mm\", up = \"x\", front = \"-y\", "
        "offset = [1, 2, 3] }\n" +
        atRest + "[hair]\nset = 0.5\ndensity = 2\ndiameter = 60\ntaper = 0.3\n");
    const Part& part = style.parts.at(0);
    ASSERT_TRUE(part.groom);
    EXPECT_EQ(part.groom->path, "/scans/me.ply");
    EXPECT_EQ(part.groom->placement.unit, 0.001);
    EXPECT_EQ(part.groom->placement.up, (Vec3d{1, 0, 0}));
    EXPECT_EQ(part.groom->placement.front, (Vec3d{0, -1, 0}));
    EXPECT_EQ(part.groom->placement.offset, (Vec3d{0.01, 0.02, 0.03}));
    EXPECT_EQ(part.hair.set, 0.5);
    EXPECT_EQ(part.hair.density, 2000);
    EXPECT_EQ(part.hair.diameter, 60e-6);
    EXPECT_EQ(part.hair.taper, 0.3);
    EXPECT_EQ(part.name, "hair");
}

TEST(ReadStyle, ReadsAGroomByItsOwnHeaderBesideHairThatGrows) {
    const Style style = read(atRest +
                             "[[part]]\n[part.groom]\nfile = \"a.obj\"\nunit = 2.5\n[[part]]\n"
                             "[part.scalp]\nellipsoid = { semi_axes = [10, 12, 8] }\ncount = 5\n"
                             "[part.hair]\nlength = 25\n");
    ASSERT_EQ(style.parts.size(), 2U);
    EXPECT_EQ(style.parts[0].groom->placement.unit, 0.025);
    EXPECT_FALSE(style.parts[1].groom);
}

TEST(ReadStyle, ReadsNaturalShapesInMetres) {
    const auto style = parseStyle(
        "kushi = 1\n[solver]\nmethod = \"equilibrium\"\ngrading = 1.5\n[scalp]\n"
        "ellipsoid = { semi_axes = [10, 12, 8] }\ncount = 5\n[hair]\nlength = 20\n"
        "shear_modulus = 1.2\ntaper = 0.4\ncurl = { radius = 0.4, pitch = 1.5, variation = 0 }\n",
        "a.toml");
    ASSERT_TRUE(style) << toString(style.problems()[0]);
    EXPECT_EQ(style->solver.method, Method::Equilibrium);
    EXPECT_EQ(style->solver.grading, 1.5);
    const Hair& hair = style->parts[0].hair;
    EXPECT_EQ(hair.shearModulus, 1.2e9);
    EXPECT_EQ(hair.taper, 0.4);
    ASSERT_TRUE(hair.curl);
    EXPECT_EQ(hair.curl->radius, 0.004);
    EXPECT_EQ(hair.curl->pitch, 0.015);
    EXPECT_EQ(hair.curl->variation, 0);
    EXPECT_FALSE(hair.wave);
    // GJ = 2 G I for a round section.
    EXPECT_NEAR(hair.torsionalRigidity() / hair.rigidity(), 2 * 1.2 / 3.9, 1e-12);
}

}  // namespace
}  // namespace kushi
