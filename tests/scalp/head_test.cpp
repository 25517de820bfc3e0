// SPDX-License-Identifier: Apache-2.0
#include "io/temp_folder.h"

#include <kushi/follicles.h>
#include <kushi/head.h>
#include <kushi/image.h>
#include <kushi/mesh_io.h>

#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <functional>
#include <map>
#include <numbers>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

namespace kushi {
namespace {

constexpr double pi = std::numbers::pi;

Scalp onHead(double spacing) {
    Scalp scalp;
    scalp.ellipsoid = headEllipsoid();
    scalp.spacing = spacing;
    scalp.surface = ScalpSurface::Head;
    return scalp;
}

RootRanges hairline() {
    RootRanges ranges;
    for (const AngleRange& range : hairRegion())
        ranges.push_back({{range.thetaLow, range.thetaHigh}, {range.phiLow, range.phiHigh}});
    return ranges;
}

// Smaller than the scalp's, of another shape, and not about its centre.
const Ellipsoid skull = {{0.004, -0.003, 0.002}, {0.094, 0.118, 0.079}, radians(-10)};

double areaOf(const Mesh& mesh, std::size_t triangle) {
    const auto& [a, b, c] = mesh.triangles[triangle];
    const Vec3d origin = mesh.vertices[a].as<double>();
    return length(cross(mesh.vertices[b].as<double>() - origin,
                        mesh.vertices[c].as<double>() - origin)) /
           2;
}

Vec3d middleOf(const Mesh& mesh, std::size_t triangle) {
    const auto& [a, b, c] = mesh.triangles[triangle];
    return (mesh.vertices[a].as<double>() + mesh.vertices[b].as<double>() +
            mesh.vertices[c].as<double>()) /
           3;
}

// Area of the triangles whose middle is where `grows` says, by the scalp's angles.
double areaWhere(const Mesh& mesh, const Scalp& scalp,
                 const std::function<bool(EllipsoidAngles)>& grows) {
    double area = 0;
    for (std::size_t i = 0; i < mesh.triangles.size(); ++i) {
        if (grows(scalp.ellipsoid.angles(middleOf(mesh, i)))) area += areaOf(mesh, i);
    }
    return area;
}

Follicles planted(const Scalp& scalp, const Mesh& head, std::uint64_t seed = 1) {
    Result<Follicles> follicles = plant(scalp, seed, head);
    EXPECT_TRUE(follicles.ok()) << toString(follicles.problems()[0]);
    return follicles ? *follicles : Follicles{};
}

std::string refusal(const Scalp& scalp, const Mesh& head) {
    const Result<Follicles> follicles = plant(scalp, 1, head);
    EXPECT_FALSE(follicles.ok());
    return follicles.ok() ? "" : toString(follicles.problems()[0]);
}

double meanNearest(const Follicles& follicles) {
    // In cells as wide as neighbours are far.
    const double cell = 2 * follicles.spacing;
    using Key = std::tuple<int, int, int>;
    const auto keyOf = [&](Vec3d p) {
        return Key{static_cast<int>(std::floor(p.x / cell)),
                   static_cast<int>(std::floor(p.y / cell)),
                   static_cast<int>(std::floor(p.z / cell))};
    };
    std::map<Key, std::vector<Vec3d>> cells;
    for (const Vec3d root : follicles.roots)
        cells[keyOf(root)].push_back(root);
    double sum = 0;
    for (const Vec3d root : follicles.roots) {
        double least = cell;
        const auto [x, y, z] = keyOf(root);
        for (int i = 0; i < 27; ++i) {
            const auto found = cells.find(Key{x + i % 3 - 1, y + i / 3 % 3 - 1, z + i / 9 - 1});
            if (found == cells.end()) continue;
            for (const Vec3d other : found->second) {
                if (!(other == root)) least = std::min(least, length(other - root));
            }
        }
        sum += least;
    }
    return sum / static_cast<double>(follicles.size());
}

TEST(PlantOnHead, CarriesFolliclesAlongTheLinesToTheCentre) {
    const Mesh head = ellipsoidMesh(skull, 200);
    const Scalp scalp = onHead(0.004);
    const Follicles follicles = planted(scalp, head);
    ASSERT_GT(follicles.size(), 5000U);
    ASSERT_EQ(follicles.normals.size(), follicles.size());
    for (std::size_t i = 0; i < follicles.size(); ++i) {
        const Vec3d root = follicles.roots[i];
        ASSERT_NEAR(skull.implicit(root), 0, 2e-3);
        ASSERT_LT(skull.implicit(root), 1e-6);
        const Vec3d above = scalp.ellipsoid.point(follicles.angles[i]);
        ASSERT_LT(length(cross(normalized(root), normalized(above))), 1e-6);
        ASSERT_NEAR(length(follicles.normals[i]), 1, 1e-12);
        // Flat triangles of this size turn by up to 0.9 degrees; blended normals do not.
        ASSERT_GT(dot(follicles.normals[i], skull.normal(root)), std::cos(radians(0.1)));
    }
}

// Where the scalp's own density would be up to 40 % too high.
TEST(PlantOnHead, IsAsDenseAsAskedEverywhereOnTheHead) {
    const Mesh head = ellipsoidMesh(skull, 200);
    const Scalp scalp = onHead(0.0015);
    const Follicles follicles = planted(scalp, head);
    for (double theta = 0; theta < 150; theta += 30) {
        for (double phi = -180; phi < 180; phi += 60) {
            const auto within = [&](EllipsoidAngles at) {
                return at.theta >= radians(theta) && at.theta < radians(theta + 30) &&
                       at.phi >= radians(phi) && at.phi < radians(phi + 60);
            };
            const auto number = std::ranges::count_if(follicles.angles, within);
            const double spacing =
                std::sqrt(areaWhere(head, scalp, within) / static_cast<double>(number));
            EXPECT_NEAR(spacing, 0.0015, 0.03 * 0.0015) << theta << ' ' << phi;
        }
    }
}

TEST(PlantOnHead, KeepsTheSpacingOnTheMannequin) {
    const Mesh head = mannequin();
    for (const double spacing : {0.002, 0.004}) {
        Scalp scalp = onHead(spacing);
        scalp.groups = {"scalp"};
        const Follicles follicles = planted(scalp, head);
        double area = 0;
        for (std::size_t i = 0; i < head.triangles.size(); ++i)
            area += head.groups[i] == 1 ? areaOf(head, i) : 0;
        EXPECT_NEAR(std::sqrt(area / static_cast<double>(follicles.size())), spacing,
                    0.03 * spacing);

        // As near to each other as on the ellipsoid itself.
        scalp.surface = ScalpSurface::Ellipsoid;
        scalp.regions = hairline();
        const double before = meanNearest(planted(scalp, {}));
        EXPECT_NEAR(meanNearest(follicles), before, 0.05 * before);
    }
}

TEST(PlantOnHead, MeetsACount) {
    const Mesh head = mannequin();
    for (const int count : {1, 40, 3000, 50000}) {
        Scalp scalp = onHead(0);
        scalp.spacing.reset();
        scalp.count = count;
        scalp.regions = hairline();
        EXPECT_NEAR(static_cast<double>(planted(scalp, head).size()), count, 0.005 * count);
    }
}

TEST(PlantOnHead, PreviewsAreEvenlySpreadSubsets) {
    const Scalp scalp = onHead(0.003);
    const Follicles all = planted(scalp, mannequin());
    const Follicles some = thin(all, all.size() / 4);
    EXPECT_EQ(some.normals.size(), some.size());
    for (std::size_t i = 0; i < some.size(); i += 50) {
        const auto found = std::ranges::find(all.keys, some.keys[i]) - all.keys.begin();
        EXPECT_EQ(all.roots[static_cast<std::size_t>(found)], some.roots[i]);
        EXPECT_EQ(all.normals[static_cast<std::size_t>(found)], some.normals[i]);
    }
    // Twice as far apart, and at least as even.
    EXPECT_GT(meanNearest(some), 1.9 * meanNearest(all));
}

Mesh joined(const Mesh& a, const Mesh& b) {
    Mesh mesh = a;
    const auto first = static_cast<std::uint32_t>(a.vertices.size());
    mesh.vertices.insert(mesh.vertices.end(), b.vertices.begin(), b.vertices.end());
    mesh.normals.insert(mesh.normals.end(), b.normals.begin(), b.normals.end());
    for (const auto& [i, j, k] : b.triangles)
        mesh.triangles.push_back({first + i, first + j, first + k});
    mesh.groups.assign(a.triangles.size(), 0);
    mesh.groups.resize(mesh.triangles.size(), 1);
    mesh.groupNames = {{"Skin", "outer"}, {"Skin", "inner"}};
    return mesh;
}

Mesh twoShells() {
    Ellipsoid inner = skull;
    inner.semiAxes *= 0.8;
    return joined(ellipsoidMesh(skull, 60), ellipsoidMesh(inner, 60));
}

TEST(PlantOnHead, TakesTheOutermostSurface) {
    for (const Vec3d root : planted(onHead(0.01), twoShells()).roots)
        EXPECT_GT(skull.implicit(root), -0.02);
}

TEST(PlantOnHead, GrowsOnTheGroupsAlone) {
    Scalp scalp = onHead(0.01);
    scalp.groups = {"inner"};
    const Follicles follicles = planted(scalp, twoShells());
    for (const Vec3d root : follicles.roots)
        EXPECT_LT(skull.implicit(root), -0.3);
    scalp.groups = {"Skin"};
    for (const Vec3d root : planted(scalp, twoShells()).roots)
        EXPECT_GT(skull.implicit(root), -0.02);
}

TEST(PlantOnHead, RefusesGroupsThatTheHeadDoesNotHave) {
    Scalp scalp = onHead(0.01);
    scalp.groups = {"inner", "scalp"};
    scalp.groupsPlace = {"a.toml", 7, 3};
    EXPECT_EQ(refusal(scalp, twoShells()),
              "a.toml:7:3: error: groups: the head has no \"scalp\", expected one of \"Skin\", "
              "\"inner\", \"outer\"");
    EXPECT_THAT(refusal(scalp, ellipsoidMesh(skull, 20)),
                testing::HasSubstr("nor any named group, object or material at all"));
}

TEST(PlantOnHead, NormalsPointOutwardsFromAPieceWoundTheWrongWay) {
    Mesh head = ellipsoidMesh(skull, 60);
    for (auto& triangle : head.triangles)
        std::swap(triangle[1], triangle[2]);
    computeNormals(head);
    const Follicles follicles = planted(onHead(0.01), head);
    for (std::size_t i = 0; i < follicles.size(); ++i)
        EXPECT_GT(dot(follicles.normals[i], skull.normal(follicles.roots[i])), 0.99);
}

TEST(PlantOnHead, NothingGrowsWhereThereIsNoHead) {
    Mesh head = ellipsoidMesh(skull, 100);
    std::erase_if(head.triangles, [&](const auto& t) { return head.vertices[t[0]].x < 0; });
    const Follicles follicles = planted(onHead(0.004), head);
    EXPECT_GT(follicles.size(), 2000U);
    for (const Vec3d root : follicles.roots)
        EXPECT_GT(root.x, -0.005);
    EXPECT_NEAR(static_cast<double>(follicles.size()) * 0.004 * 0.004,
                areaWhere(head, onHead(1), [](EllipsoidAngles) { return true; }), 0.0015);
}

TEST(PlantOnHead, SaysThatAHeadIsOutOfReach) {
    Ellipsoid giant = headEllipsoid();
    giant.semiAxes += Vec3d{0.03, 0.03, 0.03};
    EXPECT_THAT(refusal(onHead(0.01), ellipsoidMesh(giant, 50)),
                testing::HasSubstr("nothing of the head's surface that hair may grow on"));
    giant.semiAxes += Vec3d{-0.012, -0.012, -0.012};
    EXPECT_GT(planted(onHead(0.01), ellipsoidMesh(giant, 50)).size(), 1000U);
    EXPECT_THAT(refusal(onHead(0.01), {}), testing::HasSubstr("nothing of the head's surface"));
}

// A head with texture coordinates: u from 0 to 1 with z, v with y.
Mesh unwrapped() {
    Mesh head = ellipsoidMesh(skull, 100);
    for (const auto& triangle : head.triangles) {
        std::array<TexturePoint, 3> corners;
        for (std::size_t k = 0; k < 3; ++k) {
            const Vec3f p = head.vertices[triangle[k]];
            corners[k] = {p.z / 0.2F + 0.5F, p.y / 0.3F + 0.5F};
        }
        head.uvs.push_back(corners);
    }
    return head;
}

// Linear light that is stored as a share of white (IEC 61966-2-1).
Rgb grey(double stored) {
    const double linear =
        stored <= 0.04045 ? stored / 12.92 : std::pow((stored + 0.055) / 1.055, 2.4);
    return Rgb{1, 1, 1} * static_cast<float>(linear);
}

// Rows from the top, of shares from the left.
std::string paint(const test::TempFolder& folder, const std::vector<std::vector<double>>& rows) {
    Image image = {static_cast<int>(rows[0].size()), static_cast<int>(rows.size()), {}};
    for (const auto& row : rows) {
        for (const double share : row)
            image.pixels.push_back(grey(share));
    }
    EXPECT_TRUE(writePng(image, folder.path("mask.png")).ok());
    return folder.path("mask.png");
}

TEST(PlantOnHead, AMaskThinsHairByItsBrightness) {
    const test::TempFolder folder;
    const Mesh head = unwrapped();
    Scalp scalp = onHead(0.0025);
    const Follicles all = planted(scalp, head);
    // Dark at the person's left; below, brighter at the right.
    scalp.mask = paint(folder, {{0, 0, 0.6, 0.6}, {0, 0, 0.6, 0.6}, {0, 0, 1, 1}, {0, 0, 1, 1}});
    const Follicles some = planted(scalp, head);
    const auto count = [](const Follicles& f, bool right, bool top) {
        return static_cast<double>(std::ranges::count_if(f.roots, [&](Vec3d p) {
            // Away from the edges, across which brightness is blended.
            return std::abs(p.y) < 0.1 && std::abs(p.z) < 0.07 &&
                   (right ? p.z > 0.03 : p.z < -0.03) && (top ? p.y > 0.04 : p.y < -0.04);
        }));
    };
    EXPECT_EQ(count(some, false, true), 0);
    EXPECT_EQ(count(some, false, false), 0);
    EXPECT_EQ(count(some, true, false), count(all, true, false));
    EXPECT_NEAR(count(some, true, true) / count(all, true, true), 0.6, 0.04);
    // Each by its own key: what grows of less grows of more as well.
    scalp.mask = paint(folder, {{0.3, 0.3}, {0.3, 0.3}});
    const Follicles few = planted(scalp, head);
    scalp.mask = paint(folder, {{0.5, 0.5}, {0.5, 0.5}});
    const Follicles more = planted(scalp, head);
    EXPECT_NEAR(static_cast<double>(few.size()) / static_cast<double>(all.size()), 0.3, 0.02);
    for (const std::uint64_t key : few.keys)
        ASSERT_THAT(std::ranges::count(more.keys, key), 1);
}

TEST(PlantOnHead, CountsAndPreviewsKeepAMasksProportions) {
    const test::TempFolder folder;
    const Mesh head = unwrapped();
    Scalp scalp = onHead(0);
    scalp.spacing.reset();
    scalp.count = 20000;
    scalp.mask = paint(folder, {{0.2, 0.2, 1, 1}});
    const Follicles follicles = planted(scalp, head);
    EXPECT_NEAR(static_cast<double>(follicles.size()), 20000, 100);
    const auto share = [](const Follicles& f) {
        double left = 0;
        double right = 0;
        for (const Vec3d root : f.roots)
            (root.z > 0 ? right : left) += std::abs(root.z) > 0.03 && std::abs(root.z) < 0.07;
        return left / right;
    };
    EXPECT_NEAR(share(follicles), 0.2, 0.02);
    EXPECT_NEAR(share(thin(follicles, 4000)), 0.2, 0.04);
}

TEST(PlantOnHead, RefusesAMaskThatDoesNotGoWithTheHead) {
    const test::TempFolder folder;
    Scalp scalp = onHead(0.01);
    scalp.maskPlace = {"a.toml", 8, 1};
    scalp.mask = folder.path("none.png");
    EXPECT_THAT(refusal(scalp, mannequin()),
                testing::StartsWith("a.toml:8:1: error: mask: the head has no texture coord"));
    Mesh head = unwrapped();
    EXPECT_THAT(refusal(scalp, head), testing::HasSubstr("none.png: "));
    scalp.mask = paint(folder, {{1, 1}});
    EXPECT_GT(planted(scalp, head).size(), 1000U);
    head.uvs[head.uvs.size() / 3][1].u = std::nanf("");
    for (std::size_t i = head.uvs.size() / 3; i < head.uvs.size() / 2; ++i)
        head.uvs[i][1].u = std::nanf("");
    EXPECT_THAT(refusal(scalp, head), testing::HasSubstr("on part of where hair grows"));
}

TEST(PlantOnHead, RegionsMayBeNarrow) {
    Scalp scalp = onHead(0);
    scalp.spacing.reset();
    scalp.count = 50;
    scalp.regions = {{{radians(45.6), radians(46.1)}, {radians(-30), radians(30)}}};
    EXPECT_EQ(planted(scalp, mannequin()).size(), 50U);
}

TEST(PlantOnHead, TheEllipsoidTakesNoNoticeOfTheHead) {
    Scalp scalp = onHead(0.004);
    scalp.surface = ScalpSurface::Ellipsoid;
    EXPECT_EQ(planted(scalp, mannequin()).roots, planted(scalp, {}).roots);
}

// A head from another program, whose data has to be unpacked by hand and made .obj.
TEST(PlantOnHead, KeepsTheSpacingOnAHeadOfAnotherProgram) {
    const char* file = std::getenv("KUSHI_TEST_HEAD");
    if (file == nullptr) GTEST_SKIP() << "KUSHI_TEST_HEAD names no mesh of a head";
    const Result<Mesh> head = readMesh(file);
    ASSERT_TRUE(head.ok()) << toString(head.problems()[0]);
    Scalp scalp = onHead(0.003);
    scalp.regions = {{{0, radians(60)}, {}}};
    const Follicles follicles = planted(scalp, *head);
    const double area =
        areaWhere(*head, scalp, [](EllipsoidAngles at) { return at.theta <= radians(60); });
    EXPECT_NEAR(std::sqrt(area / static_cast<double>(follicles.size())), 0.003, 0.05 * 0.003);
}

}  // namespace
}  // namespace kushi
