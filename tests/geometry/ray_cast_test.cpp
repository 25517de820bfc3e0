// SPDX-License-Identifier: Apache-2.0
#include "geometry/ray_cast.h"

#include "core/parallel.h"
#include "core/random.h"

#include <atomic>
#include <chrono>

#include <gtest/gtest.h>

namespace kushi {
namespace {

Vec3d randomPoint(std::uint64_t key, double reach) {
    return reach * Vec3d{uniformSigned(mixKey(key, 1)), uniformSigned(mixKey(key, 2)),
                         uniformSigned(mixKey(key, 3))};
}

// Triangles anywhere in a cube of 20 cm.
Mesh scattered(std::uint32_t count) {
    Mesh mesh;
    for (std::uint32_t i = 0; i < count; ++i) {
        const Vec3d middle = randomPoint(mixKey(i, 10), 0.1);
        for (std::uint64_t k = 0; k < 3; ++k)
            mesh.vertices.push_back(
                (middle + randomPoint(mixKey(mixKey(i, 11), k), 0.03)).as<float>());
        mesh.triangles.push_back({3 * i, 3 * i + 1, 3 * i + 2});
    }
    return mesh;
}

// Moeller and Trumbore, "Fast, Minimum Storage Ray/Triangle Intersection", 1997.
double meets(const Mesh& mesh, std::size_t triangle, Vec3d from, Vec3d way) {
    const auto& [i, j, k] = mesh.triangles[triangle];
    const Vec3d a = mesh.vertices[i].as<double>();
    const Vec3d b = mesh.vertices[j].as<double>() - a;
    const Vec3d c = mesh.vertices[k].as<double>() - a;
    const Vec3d p = cross(way, c);
    const double determinant = dot(b, p);
    const double u = dot(from - a, p) / determinant;
    const Vec3d q = cross(from - a, b);
    const double v = dot(way, q) / determinant;
    const double t = dot(c, q) / determinant;
    return u >= 0 && v >= 0 && u + v <= 1 && t >= 0 && t <= 1 ? t : 2;
}

TEST(RayCaster, FindsTheFirstOfManyTriangles) {
    const Mesh mesh = scattered(300);
    const RayCaster caster(mesh);
    int hits = 0;
    for (std::uint64_t i = 0; i < 2000; ++i) {
        const Vec3d from = randomPoint(mixKey(i, 20), 0.2);
        const Vec3d to = randomPoint(mixKey(i, 21), 0.2);
        std::size_t nearest = 0;
        double least = 2;
        for (std::size_t k = 0; k < mesh.triangles.size(); ++k) {
            const double t = meets(mesh, k, from, to - from);
            if (t < least) nearest = k;
            least = std::min(least, t);
        }
        const auto hit = caster.first(from, to);
        ASSERT_EQ(hit.has_value(), least <= 1) << i;
        if (!hit) continue;
        ++hits;
        ASSERT_EQ(hit->triangle, nearest) << i;
        ASSERT_LT(length(hit->point - (from + least * (to - from))), 1e-9);
        Vec3d blended;
        for (std::size_t k = 0; k < 3; ++k)
            blended += hit->weights[k] * mesh.vertices[mesh.triangles[nearest][k]].as<double>();
        ASSERT_LT(length(blended - hit->point), 1e-12);
    }
    EXPECT_GT(hits, 500);
}

TEST(RayCaster, SeesMarkedTrianglesOnly) {
    Mesh mesh;
    for (const float x : {0.0F, 0.1F}) {
        const auto first = static_cast<std::uint32_t>(mesh.vertices.size());
        mesh.vertices.insert(mesh.vertices.end(), {{x, -1, -1}, {x, 1, -1}, {x, 0, 1}});
        mesh.triangles.push_back({first, first + 1, first + 2});
    }
    EXPECT_EQ(RayCaster(mesh).first({1, 0, 0}, {-1, 0, 0})->triangle, 1U);
    const auto behind = RayCaster(mesh, {true, false}).first({1, 0, 0}, {-1, 0, 0});
    ASSERT_TRUE(behind);
    EXPECT_EQ(behind->triangle, 0U);
    EXPECT_NEAR(behind->point.x, 0, 1e-12);
    EXPECT_NEAR(std::abs(behind->normal.x), 1, 1e-12);
    EXPECT_FALSE(RayCaster(mesh).first({1, 0, 0}, {0.2, 0, 0}));
    EXPECT_FALSE(RayCaster(mesh, {false, false}).first({1, 0, 0}, {-1, 0, 0}));
    EXPECT_FALSE(RayCaster(Mesh{}).first({1, 0, 0}, {-1, 0, 0}));
}

// Embree can hold all of the program to as many threads as it is told to use itself.
TEST(RayCaster, LeavesThreadsToOthers) {
    const Mesh ball = ellipsoidMesh({.center = {}, .semiAxes = {1, 1, 1}}, 20);
    const RayCaster caster(ball);
    std::atomic<int> here = 0;
    std::atomic<bool> met = false;
    parallelFor(2, 1, 2, [&](std::size_t, std::size_t) {
        ++here;
        const auto end = std::chrono::steady_clock::now() + std::chrono::seconds(5);
        while (!met && std::chrono::steady_clock::now() < end) {
            if (here == 2) met = true;
        }
        --here;
    });
    EXPECT_TRUE(met);
}

}  // namespace
}  // namespace kushi
