// SPDX-License-Identifier: Apache-2.0
#include "head/measure.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <map>
#include <set>
#include <tuple>
#include <utility>
#include <vector>

#include <gtest/gtest.h>

namespace kushi {
namespace {

using Index = std::uint32_t;

TEST(MannequinMesh, EveryEdgeHasTwoTrianglesThatRunAlongItInOppositeDirections) {
    std::map<std::pair<Index, Index>, int> directed;
    for (const auto& t : theHead().triangles) {
        for (std::size_t c = 0; c < 3; ++c)
            ++directed[{t[c], t[(c + 1) % 3]}];
    }
    for (const auto& [edge, count] : directed) {
        ASSERT_EQ(count, 1) << edge.first << " to " << edge.second;
        ASSERT_TRUE(directed.contains({edge.second, edge.first}))
            << edge.first << " to " << edge.second;
    }
}

TEST(MannequinMesh, TheTrianglesRoundEveryVertexFormOneFan) {
    std::vector<std::map<Index, Index>> next(theHead().vertices.size());
    for (const auto& [a, b, c] : theHead().triangles) {
        next[a][b] = c;
        next[b][c] = a;
        next[c][a] = b;
    }
    for (Index v = 0; v < next.size(); ++v) {
        ASSERT_GE(next[v].size(), 3U) << v;
        const Index first = next[v].begin()->first;
        std::size_t steps = 1;
        for (Index at = next[v].at(first); at != first; at = next[v].at(at))
            ++steps;
        ASSERT_EQ(steps, next[v].size()) << v;
    }
}

TEST(MannequinMesh, IsOnePieceWithoutHandles) {
    const auto vertices = static_cast<long>(theHead().vertices.size());
    const auto triangles = static_cast<long>(theHead().triangles.size());
    EXPECT_EQ(vertices - 3 * triangles / 2 + triangles, 2);

    std::vector<std::vector<Index>> neighbours(theHead().vertices.size());
    for (const auto& [a, b, c] : theHead().triangles) {
        neighbours[a].push_back(b);
        neighbours[b].push_back(c);
        neighbours[c].push_back(a);
    }
    std::vector<bool> reached(neighbours.size(), false);
    std::vector<Index> open = {0};
    reached[0] = true;
    std::size_t count = 0;
    while (!open.empty()) {
        const Index v = open.back();
        open.pop_back();
        ++count;
        for (const Index n : neighbours[v]) {
            if (!reached[n]) open.push_back(n);
            reached[n] = true;
        }
    }
    EXPECT_EQ(count, neighbours.size());
}

TEST(MannequinMesh, IsItsOwnMirrorImage) {
    using Point = std::tuple<float, float, float>;
    const auto point = [](Index i) {
        const Vec3f v = theHead().vertices[i];
        return Point{v.x, v.y, v.z == 0 ? 0.0F : v.z};
    };
    const auto image = [&](Index i) {
        const auto [x, y, z] = point(i);
        return Point{x, y, z == 0 ? 0.0F : -z};
    };
    const auto rotated = [](std::array<Point, 3> t) {
        std::rotate(t.begin(), std::min_element(t.begin(), t.end()), t.end());
        return t;
    };
    std::set<std::array<Point, 3>> all;
    for (const auto& [a, b, c] : theHead().triangles) {
        all.insert(rotated({point(a), point(b), point(c)}));
    }
    for (const auto& [a, b, c] : theHead().triangles) {
        ASSERT_TRUE(all.contains(rotated({image(a), image(c), image(b)})));
    }
}

// A head is about 4.5 litres, neck and bust about 9; inside out, the volume would be negative.
TEST(MannequinMesh, FacesOutwards) {
    double sixfold = 0;
    for (const auto& [a, b, c] : theHead().triangles) {
        const auto& v = theHead().vertices;
        sixfold += dot(inCm(v[a]), cross(inCm(v[b]), inCm(v[c])));
    }
    EXPECT_GT(sixfold / 6, 9000);
    EXPECT_LT(sixfold / 6, 18000);
}

TEST(MannequinMesh, HasNoDegenerateTriangles) {
    for (const auto& [a, b, c] : theHead().triangles) {
        const auto& v = theHead().vertices;
        const Vec3d u = inCm(v[b]) - inCm(v[a]);
        const Vec3d w = inCm(v[c]) - inCm(v[a]);
        const double twiceArea = length(cross(u, w));
        const double longest = std::max({length(u), length(w), length(u - w)});
        ASSERT_GT(twiceArea / longest, 0.005)
            << inCm(v[a]).x << ' ' << inCm(v[a]).y << ' ' << inCm(v[a]).z;
    }
}

TEST(MannequinMesh, NormalsAreUnitAndAgreeWithTheTriangles) {
    ASSERT_EQ(theHead().normals.size(), theHead().vertices.size());
    Mesh flat = theHead();
    computeNormals(flat);
    std::size_t off = 0;
    for (std::size_t i = 0; i < flat.normals.size(); ++i) {
        ASSERT_NEAR(length(theHead().normals[i]), 1, 1e-5F);
        const double cosine = dot(theHead().normals[i], flat.normals[i]);
        ASSERT_GT(cosine, 0.3) << inCm(flat.vertices[i]).x << ' ' << inCm(flat.vertices[i]).y;
        if (cosine < 0.95) ++off;
    }
    EXPECT_LT(off, flat.normals.size() / 100);
}

TEST(MannequinMesh, IsFineButNotTooFine) {
    EXPECT_GT(theHead().triangles.size(), 20000U);
    EXPECT_LT(theHead().triangles.size(), 60000U);
    EXPECT_TRUE(theHead().colors.empty());
}

TEST(MannequinMesh, IsTheSameAtEveryCall) {
    const Mesh again = mannequin();
    EXPECT_EQ(again.vertices, theHead().vertices);
    EXPECT_EQ(again.normals, theHead().normals);
    EXPECT_EQ(again.triangles, theHead().triangles);
}

}  // namespace
}  // namespace kushi
