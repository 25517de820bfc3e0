// SPDX-License-Identifier: Apache-2.0
#include "core/random.h"
#include "geometry/solids.h"

#include <kushi/distance_field.h>

#include <algorithm>
#include <functional>
#include <limits>

#include <gtest/gtest.h>

namespace kushi {
namespace {

using test::append;
using test::box;
using test::capsule;
using test::sphere;

constexpr double mm = 0.001;

DistanceField fieldOf(const std::vector<Solid>& solids, double spacing = 2.5 * mm) {
    Result<DistanceField> field = distanceFieldOf(solids, {spacing, 0});
    EXPECT_TRUE(field.ok());
    return field ? std::move(field).value() : DistanceField{};
}
DistanceField fieldOf(const Mesh& mesh, double offset = 0) {
    return fieldOf(std::vector<Solid>{{mesh, offset}});
}

Vec3f samplePlace(const DistanceField& field, int x, int y, int z) {
    return field.origin + field.spacing * Vec3f{static_cast<float>(x), static_cast<float>(y),
                                                static_cast<float>(z)};
}

/// Compares all samples with a closed form [m], within `facets` where distances are exact, and half
/// a spacing more elsewhere.
void expectLike(const DistanceField& field, double facets,
                const std::function<double(Vec3d)>& exact) {
    int wrong = 0;
    for (int z = 0; z < field.size[2]; ++z) {
        for (int y = 0; y < field.size[1]; ++y) {
            for (int x = 0; x < field.size[0]; ++x) {
                const Vec3f place = samplePlace(field, x, y, z);
                const double expected = exact(place.as<double>());
                const double found =
                    static_cast<double>(field.units[field.index(x, y, z)]) * double{field.unit()};
                const bool near = std::abs(expected) < 20 * mm;
                const double allowed =
                    facets + double{field.unit()} + (near ? 0.0 : 0.5 * double{field.spacing});
                if (std::abs(found - expected) <= allowed) continue;
                if (++wrong > 5) return;
                ADD_FAILURE() << "at " << place.x << ' ' << place.y << ' ' << place.z
                              << ": expected " << expected << ", found " << found;
            }
        }
    }
}

/// But for the rounding of the last digit, and for places that are as far from several triangles.
void expectSame(const DistanceField& a, const DistanceField& b) {
    ASSERT_EQ(a.units.size(), b.units.size());
    const int exactUnits = 8 * static_cast<int>(DistanceField::unitsPerSpacing);
    int near = 0, far = 0;
    for (std::size_t i = 0; i < a.units.size(); ++i) {
        int& most = std::abs(a.units[i]) < exactUnits ? near : far;
        most = std::max(most, std::abs(a.units[i] - b.units[i]));
    }
    EXPECT_LE(near, 1);
    EXPECT_LE(far, 128);  // half a spacing
}

double toBox(Vec3d p, Vec3d half) {
    const Vec3d q = {std::abs(p.x) - half.x, std::abs(p.y) - half.y, std::abs(p.z) - half.z};
    const Vec3d out = {std::max(q.x, 0.0), std::max(q.y, 0.0), std::max(q.z, 0.0)};
    return length(out) + std::min(std::max({q.x, q.y, q.z}), 0.0);
}
double toSphere(Vec3d p, Vec3d center, double radius) {
    return length(p - center) - radius;
}

// A polyhedron of 48 rows on a sphere of 5 cm lies up to r (1 - cos(pi / 96)) beneath it, along
// rows and columns.
constexpr double sphereFacets = 2 * 0.05 * 0.00054;

TEST(DistanceField, IsThatOfASphere) {
    const Vec3d center = {0.01, 0.02, -0.03};
    expectLike(fieldOf(sphere(center, 0.05)), sphereFacets,
               [&](Vec3d p) { return toSphere(p, center, 0.05); });
}

TEST(DistanceField, IsThatOfACapsule) {
    // One row of triangles makes up the cylinder and is a facet of pi / 48 wide at one end.
    expectLike(fieldOf(capsule(0.04, 0.1)), 0.04 * (0.0022 + 0.0006), [](Vec3d p) {
        const Vec3d onAxis = {0, std::clamp(p.y, -0.05, 0.05), 0};
        return length(p - onAxis) - 0.04;
    });
}

TEST(DistanceField, IsThatOfABoxWithFewTriangles) {
    const Vec3d half = {0.04, 0.05, 0.06};
    expectLike(fieldOf(box(half.as<float>())), 1e-7, [&](Vec3d p) { return toBox(p, half); });
}

TEST(DistanceField, HoldsTheSolidAndTwoCentimetresAround) {
    const DistanceField field = fieldOf(box({0.04F, 0.05F, 0.06F}), 0.01);
    const Vec3f low = field.origin;
    const Vec3f high = samplePlace(field, field.size[0] - 1, field.size[1] - 1, field.size[2] - 1);
    EXPECT_NEAR(low.x, -0.07, 1e-6);
    EXPECT_NEAR(low.y, -0.08, 1e-6);
    EXPECT_NEAR(low.z, -0.09, 1e-6);
    EXPECT_GE(high.x, 0.07F - 1e-6F);
    EXPECT_GE(high.y, 0.08F - 1e-6F);
    EXPECT_GE(high.z, 0.09F - 1e-6F);
    EXPECT_LE(high.x, 0.0726F);
}

TEST(DistanceField, AnOffsetMakesASolidLargerOrSmaller) {
    for (const double offset : {0.012, -0.012}) {
        expectLike(fieldOf(sphere({}, 0.05), offset), sphereFacets,
                   [&](Vec3d p) { return toSphere(p, {}, 0.05) - offset; });
    }
}

TEST(DistanceField, OfTwoSolidsIsThatOfTheNearerAndSaysWhich) {
    const Vec3d a = {-0.03, 0, 0}, b = {0.05, 0, 0};
    const DistanceField field = fieldOf({{sphere(a, 0.05), 0.005}, {sphere(b, 0.04), 0}});
    expectLike(field, sphereFacets,
               [&](Vec3d p) { return std::min(toSphere(p, a, 0.055), toSphere(p, b, 0.04)); });
    ASSERT_EQ(field.nearest.size(), field.units.size());
    for (int x = 0; x < field.size[0]; ++x) {
        const Vec3f place = samplePlace(field, x, field.size[1] / 2, field.size[2] / 2);
        const double toA = toSphere(place.as<double>(), a, 0.055);
        const double toB = toSphere(place.as<double>(), b, 0.04);
        if (std::abs(toA - toB) < 2 * mm) continue;
        EXPECT_EQ(field.nearest[field.index(x, field.size[1] / 2, field.size[2] / 2)],
                  toA < toB ? 0 : 1);
    }
    EXPECT_TRUE(fieldOf(sphere({}, 0.05)).nearest.empty());
}

TEST(DistanceField, DoesNotMindWhichWayTrianglesFace) {
    Mesh mesh = sphere({}, 0.05);
    const DistanceField field = fieldOf(mesh);
    for (std::size_t i = 0; i < mesh.triangles.size(); ++i) {
        if (uniform(i) < 0.3) test::turn(mesh.triangles[i]);
    }
    expectSame(fieldOf(mesh), field);
    for (auto& triangle : mesh.triangles)
        test::turn(triangle);
    expectSame(fieldOf(mesh), field);
}

TEST(DistanceField, TakesTrianglesWithCornersOfTheirOwn) {
    const Mesh mesh = sphere({}, 0.05);
    Mesh soup;
    for (const auto& triangle : mesh.triangles) {
        for (const std::uint32_t corner : triangle)
            soup.vertices.push_back(mesh.vertices[corner]);
        const auto end = static_cast<std::uint32_t>(soup.vertices.size());
        soup.triangles.push_back({end - 3, end - 2, end - 1});
    }
    expectSame(fieldOf(soup), fieldOf(mesh));
}

TEST(DistanceField, DoesNotMindRepeatedTriangles) {
    Mesh mesh = sphere({}, 0.05);
    const DistanceField field = fieldOf(mesh);
    const std::size_t count = mesh.triangles.size();
    for (std::size_t i = 0; i < count; ++i) {
        if (i % 3 == 0) mesh.triangles.push_back(mesh.triangles[i]);
        if (i % 5 == 0) test::turn(mesh.triangles.emplace_back(mesh.triangles[i]));
    }
    expectSame(fieldOf(mesh), field);
}

TEST(DistanceField, DoesNotMindTrianglesWithoutAnArea) {
    Mesh mesh = box({0.04F, 0.04F, 0.04F});
    mesh.triangles.push_back({0, 0, 5});
    mesh.triangles.push_back({3, 3, 3});
    mesh.vertices.push_back({0.04F, 0.04F, 0});  // on the edge from 3 to 7
    mesh.triangles.push_back({3, 7, 8});
    expectLike(fieldOf(mesh), 1e-7, [](Vec3d p) { return toBox(p, {0.04, 0.04, 0.04}); });
}

/// The half of a sphere above y = 0.
Mesh hemisphere(double radius) {
    Mesh mesh = sphere({}, radius);
    std::erase_if(mesh.triangles, [&mesh](const auto& triangle) {
        return std::ranges::any_of(
            triangle, [&mesh](std::uint32_t corner) { return mesh.vertices[corner].y < -1e-6F; });
    });
    return mesh;
}

TEST(DistanceField, AnOpenMeshIsClosedAcrossItsOpening) {
    Mesh mesh = hemisphere(0.05);
    for (auto& triangle : mesh.triangles)
        test::turn(triangle);  // inwards
    expectLike(fieldOf(mesh), sphereFacets, [](Vec3d p) {
        const double out = std::hypot(p.x, p.z);
        if (p.y >= 0) return std::max(length(p) - 0.05, -p.y);
        return std::hypot(std::max(out - 0.05, 0.0), p.y);
    });
}

/// Below 0 inside of two spheres of 5 cm about (-3, 0, 0) and (3, 0, 0) cm, as deep as their union.
double toTwoSpheres(Vec3d p) {
    const Vec3d center = {p.x < 0 ? -0.03 : 0.03, 0, 0};
    if (const double distance = toSphere(p, center, 0.05); distance >= 0) return distance;
    // They meet in a circle of 4 cm, which hides what of them is beyond.
    double depth = std::hypot(p.x, std::hypot(p.y, p.z) - 0.04);
    for (const double x : {-0.03, 0.03}) {
        const Vec3d from = p - Vec3d{x, 0, 0};
        const Vec3d onSphere = Vec3d{x, 0, 0} + (0.05 / length(from)) * from;
        if (onSphere.x * x > 0) depth = std::min(depth, std::abs(0.05 - length(from)));
    }
    return -depth;
}

TEST(DistanceField, IsTheUnionOfPiecesThatCutEachOther) {
    Mesh mesh = sphere({-0.03, 0, 0}, 0.05);
    append(mesh, sphere({0.03, 0, 0}, 0.05));
    for (std::size_t i = 0; i < mesh.triangles.size() / 2; ++i)
        test::turn(mesh.triangles[i]);
    const DistanceField field = fieldOf(mesh);
    EXPECT_TRUE(field.nearest.empty());
    // Triangles that cross the circle reach inside by 4.7 mm at most, their longest side.
    expectLike(field, 4.7 * mm, toTwoSpheres);
    for (const double x : {-0.1, -0.085, 0.085, 0.1}) {
        const Vec3d place = {x, 0.006, 0.004};
        EXPECT_NEAR(distanceAt(field, place.as<float>()), toTwoSpheres(place),
                    sphereFacets + 0.1 * mm);
    }
}

TEST(DistanceField, ManyPiecesInsideDoNotShow) {
    const Mesh outer = sphere({}, 0.05);
    Mesh mesh = outer;
    append(mesh, sphere({0.01, 0, 0}, 0.03));
    append(mesh, box({0.01F, 0.02F, 0.01F}));
    Mesh sheet;
    sheet.vertices = {{-0.02F, 0.01F, 0.01F}, {0, 0.03F, 0.02F}, {0.01F, -0.02F, 0.03F}};
    sheet.triangles = {{0, 1, 2}};
    append(mesh, sheet);
    expectSame(fieldOf(mesh), fieldOf(outer));
}

TEST(DistanceField, AFinIsASheetAndLeavesTheRestAsItIs) {
    Mesh mesh = box({0.04F, 0.04F, 0.04F});
    mesh.vertices.push_back({0.06F, 0.06F, 0});
    mesh.triangles.push_back({3, 7, 8});  // on an edge of the box
    const DistanceField field = fieldOf(mesh);
    EXPECT_NEAR(distanceAt(field, {0, 0.05F, 0}), 0.01, 0.1 * mm);
    EXPECT_NEAR(distanceAt(field, {0, -0.05F, 0}), 0.01, 0.1 * mm);
    EXPECT_NEAR(distanceAt(field, {0.02F, 0, 0}), -0.02, 0.1 * mm);
    // Beside the fin, on either side, and never inside it.
    EXPECT_NEAR(distanceAt(field, {0.057F, 0.043F, 0}), 0.0099, 0.2 * mm);
    EXPECT_NEAR(distanceAt(field, {0.043F, 0.057F, 0}), 0.0099, 0.2 * mm);
    EXPECT_GE(distanceAt(field, {0.05F, 0.05F, 0}), 0);
}

TEST(DistanceField, SaysHowFarAPlaceOutsideOfTheGridIs) {
    const DistanceField field = fieldOf(sphere({}, 0.05));
    // At most a corner of the grid farther than straight there.
    for (const Vec3f place : {Vec3f{1, 0, 0}, Vec3f{0, -2, 0.5F}, Vec3f{3, 3, 3}}) {
        const double exact = toSphere(place.as<double>(), {}, 0.05);
        EXPECT_GE(distanceAt(field, place), exact - mm);
        EXPECT_LE(distanceAt(field, place), exact + 0.05);
    }
    EXPECT_NEAR(distanceAt(field, {1, 0, 0}), 0.95, mm);
    const float nan = std::numeric_limits<float>::quiet_NaN();
    EXPECT_TRUE(std::isnan(distanceAt(field, {nan, 0, 0})));
}

TEST(DistanceField, IsLinearBetweenSamples) {
    const DistanceField field = fieldOf(box({0.04F, 0.04F, 0.04F}));
    for (const float y : {0.0413F, 0.0437F, 0.0499F, 0.0391F, 0.0357F})
        EXPECT_NEAR(distanceAt(field, {0.003F, y, -0.002F}), y - 0.04F, 0.02 * mm);
}

TEST(DistanceField, WithoutTrianglesIsEmptyAndFarFromEverything) {
    const DistanceField none = fieldOf(std::vector<Solid>{});
    EXPECT_TRUE(none.empty());
    EXPECT_EQ(distanceAt(none, {0, 0, 0}), 1);
    Mesh points;
    points.vertices = {{0, 0, 0}, {1, 1, 1}};
    EXPECT_TRUE(fieldOf(points).empty());
    // A solid without triangles beside one that has some.
    const DistanceField field = fieldOf({{points, 0}, {sphere({}, 0.05), 0}});
    EXPECT_NEAR(distanceAt(field, {0, 0.06F, 0}), 0.01, 0.1 * mm);
    EXPECT_EQ(field.nearest[field.index(20, 20, 20)], 1);
}

TEST(DistanceField, ChoosesASpacingForSolidsOfAnySize) {
    EXPECT_EQ(distanceFieldOf(std::vector<Solid>{{sphere({}, 0.05, 8), 0}})->spacing, 0.0025F);
    const std::vector<Solid> large = {{sphere({}, 2, 8), 0}};
    const DistanceField field = *distanceFieldOf(large);
    EXPECT_LE(field.units.size(), 24'000'000U);
    EXPECT_GT(field.units.size(), 22'000'000U);
}

TEST(DistanceField, HasTheSameBytesFromAnyNumberOfThreads) {
    const std::vector<Solid> solids = {{sphere({}, 0.05), 0.002}, {box({0.03F, 0.07F, 0.03F}), 0}};
    const DistanceField one = *distanceFieldOf(solids, {{}, 1});
    for (const int threads : {2, 3, 7}) {
        const DistanceField more = *distanceFieldOf(solids, {{}, threads});
        EXPECT_EQ(one.units, more.units);
        EXPECT_EQ(one.nearest, more.nearest);
    }
}

TEST(DistanceField, RefusesWhatIsNoSolid) {
    const auto messageOf = [](const Solid& solid, std::optional<double> spacing = {}) {
        const std::vector<Solid> solids = {solid};
        const Result<DistanceField> field = distanceFieldOf(solids, {spacing, 0});
        return field ? std::string() : field.problems().front().message;
    };
    const float nan = std::numeric_limits<float>::quiet_NaN();
    const double infinite = std::numeric_limits<double>::infinity();
    Solid solid = {sphere({}, 0.05, 8), 0};
    EXPECT_EQ(messageOf(solid), "");
    for (const double spacing : {0.0, -1.0, infinite, double{nan}}) {
        EXPECT_EQ(messageOf(solid, spacing),
                  "the spacing of a distance field is above 0 and at most 1000 m");
    }
    EXPECT_EQ(messageOf(solid, 1e-6),
              "a spacing of 0.001000 mm takes more than 256 million "
              "samples of the distance field");
    solid.offset = double{nan};
    EXPECT_EQ(messageOf(solid), "solid 1: its offset is not a number of metres from -1000 to 1000");
    solid.offset = 0;
    for (const float bad : {nan, std::numeric_limits<float>::infinity(), 2000.0F}) {
        solid.mesh.vertices[3].z = bad;
        EXPECT_EQ(messageOf(solid),
                  "solid 1: a vertex of its mesh is not finite, or farther than "
                  "1 km from the origin");
    }
    solid.mesh.vertices[3].z = 0;
    solid.mesh.triangles[5][1] = 100000;
    EXPECT_EQ(messageOf(solid),
              "solid 1: a triangle of its mesh has a vertex that the mesh does not have");
    const std::vector<Solid> many(256);
    EXPECT_FALSE(distanceFieldOf(many).ok());
}

}  // namespace
}  // namespace kushi
