// SPDX-License-Identifier: Apache-2.0
//
// The distance field of whole heads against looking at every triangle.
#include "core/random.h"
#include "geometry/brute_force.h"
#include "head/measure.h"

#include <kushi/distance_field.h>

#include <array>
#include <cstdio>
#include <filesystem>
#include <map>
#include <memory>
#include <set>
#include <sstream>
#include <string>

#include <gtest/gtest.h>

namespace kushi {
namespace {

constexpr double mm = 0.001;

/// Random samples of the field, half of them near the surface.
void expectLikeBruteForce(const DistanceField& field, const Mesh& closed, int count) {
    int near = 0, inside = 0;
    const auto below = [](std::uint64_t key, int end) {
        return static_cast<int>(uniform(key) * end);
    };
    for (std::uint64_t key = 0, done = 0; done < static_cast<std::uint64_t>(count); ++key) {
        const int x = below(3 * key, field.size[0]), y = below(3 * key + 1, field.size[1]),
                  z = below(3 * key + 2, field.size[2]);
        const std::int16_t units = field.units[field.index(x, y, z)];
        // Most places are far from the surface: one in ten of them will do.
        const float found = static_cast<float>(units) * field.unit();
        if (std::abs(found) > 4 * field.spacing && key % 10 != 0) continue;
        ++done;
        const Vec3f place =
            field.origin + field.spacing * Vec3f{static_cast<float>(x), static_cast<float>(y),
                                                 static_cast<float>(z)};
        const double distance = test::distanceToMesh(closed, place.as<double>());
        const double winding = test::windingOfMesh(closed, place.as<double>());
        if (distance > 0.01 * mm) {
            EXPECT_EQ(found<0, winding> 0.5) << winding << " at " << distance;
        }
        const bool exact = distance < 20 * mm;
        EXPECT_NEAR(std::abs(found), distance,
                    exact ? 0.51 * double{field.unit()} : 0.5 * double{field.spacing});
        near += exact ? 1 : 0;
        inside += winding > 0.5 ? 1 : 0;
    }
    EXPECT_GT(near, count / 3);
    EXPECT_GT(inside, count / 5);
}

TEST(HeadField, OfTheMannequinIsThatOfBruteForce) {
    const std::vector<Solid> solids = {{theHead(), 0}};
    const Result<DistanceField> field = distanceFieldOf(solids);
    ASSERT_TRUE(field.ok());
    EXPECT_EQ(field->spacing, 0.0025F);
    expectLikeBruteForce(*field, theHead(), 400);
}

// Heads made by others: CGAL's, which Debian packs with its documentation (libcgal-demo). They are
// no part of Kushi.
const char* const archive = "/usr/share/doc/libcgal-dev/data.tar.gz";

std::string textOf(const std::string& command) {
    std::string text;
    const std::unique_ptr<std::FILE, int (*)(std::FILE*)> pipe(popen(command.c_str(), "r"), pclose);
    if (pipe == nullptr) return text;
    std::array<char, 65536> part{};
    while (const std::size_t size = std::fread(part.data(), 1, part.size(), pipe.get()))
        text.append(part.data(), size);
    return text;
}

/// A mesh of triangles in an OFF file; `unit` in metres.
Mesh packedMesh(const std::string& name, float unit) {
    std::istringstream in(
        textOf(std::string("tar -xzOf ") + archive + " data/meshes/" + name + ".off"));
    std::string off;
    std::size_t vertices = 0, faces = 0, edges = 0, corners = 0;
    in >> off >> vertices >> faces >> edges;
    Mesh mesh;
    mesh.vertices.resize(vertices);
    for (Vec3f& vertex : mesh.vertices) {
        in >> vertex.x >> vertex.y >> vertex.z;
        vertex *= unit;
    }
    mesh.triangles.resize(faces);
    for (auto& [a, b, c] : mesh.triangles)
        in >> corners >> a >> b >> c;
    return mesh;
}

/// The mesh with a fan around the middle of each of its openings, each a simple loop.
Mesh closedByFans(Mesh mesh) {
    std::set<std::pair<std::uint32_t, std::uint32_t>> sides;
    for (const auto& t : mesh.triangles) {
        for (std::size_t k = 0; k < 3; ++k)
            sides.insert({t[k], t[(k + 1) % 3]});
    }
    std::map<std::uint32_t, std::uint32_t> next;
    for (const auto& [from, to] : sides) {
        if (!sides.contains({to, from})) next[to] = from;
    }
    while (!next.empty()) {
        std::vector<std::uint32_t> loop = {next.begin()->first};
        for (auto at = next.begin(); at != next.end(); at = next.find(loop.back())) {
            loop.push_back(at->second);
            next.erase(at);
        }
        Vec3f sum;
        for (std::size_t i = 1; i < loop.size(); ++i)
            sum += mesh.vertices[loop[i]];
        mesh.vertices.push_back(sum / static_cast<float>(loop.size() - 1));
        const auto middle = static_cast<std::uint32_t>(mesh.vertices.size() - 1);
        for (std::size_t i = 1; i < loop.size(); ++i)
            mesh.triangles.push_back({loop[i - 1], loop[i], middle});
    }
    return mesh;
}

TEST(HeadField, OfAHeadThatFacesInwardsWithAnOpenNeckAndEyes) {
    if (!std::filesystem::exists(archive)) GTEST_SKIP() << "there is no " << archive;
    const Mesh head = packedMesh("head", 0.01F);
    ASSERT_EQ(head.triangles.size(), 2918U);
    const std::vector<Solid> solids = {{head, 0}};
    const Result<DistanceField> field = distanceFieldOf(solids);
    ASSERT_TRUE(field.ok());
    Mesh closed = closedByFans(head);
    for (auto& triangle : closed.triangles)
        std::swap(triangle[1], triangle[2]);
    expectLikeBruteForce(*field, closed, 1000);
}

TEST(HeadField, OfAWholeMan) {
    if (!std::filesystem::exists(archive)) GTEST_SKIP() << "there is no " << archive;
    const Mesh man = packedMesh("man", 1.8F);
    ASSERT_EQ(man.triangles.size(), 34986U);
    const std::vector<Solid> solids = {{man, 0}};
    const Result<DistanceField> field = distanceFieldOf(solids);
    ASSERT_TRUE(field.ok());
    expectLikeBruteForce(*field, man, 200);
}

}  // namespace
}  // namespace kushi
