// SPDX-License-Identifier: Apache-2.0
//
// Whole heads of hair against the triangles that they are kept out of.
#include "fields.h"
#include "pipeline/hair_in_mesh.h"
#include "pipeline/push_all_out.h"

#include <kushi/head.h>
#include <kushi/settle.h>

#include <algorithm>
#include <array>
#include <cstdio>
#include <filesystem>

#include <gtest/gtest.h>

namespace kushi {
namespace {

#if defined(__SANITIZE_ADDRESS__)
constexpr std::size_t strands = 12;
#else
constexpr std::size_t strands = 40;
#endif

const Mesh& head() {
    static const Mesh mesh = mannequin();
    return mesh;
}

const test::SolidMesh& solidHead() {
    static const test::SolidMesh solid(head());
    return solid;
}

struct Gravity {
    const char* name;
    Vec3d way;
};
constexpr std::array<Gravity, 5> gravities = {{{"down", {0, -1, 0}},
                                               {"up", {0, 1, 0}},
                                               {"front", {1, 0, 0}},
                                               {"back", {-1, 0, 0}},
                                               {"left", {0, 0, -1}}}};

// A style with few hairs, all of a length.
Style trimmed(const Style& style, Method method, double length, Vec3d gravity) {
    Style other = style;
    other.solver.method = method;
    other.gravity = gravity;
    for (Part& part : other.parts) {
        part.scalp.spacing.reset();
        part.scalp.count = static_cast<int>(strands / other.parts.size());
        const bool curls = part.hair.curl || part.hair.wave;
        if (curls) {
            // As finely as before.
            other.solver.segments = static_cast<int>(
                std::ceil(style.solver.segments * std::max(1.0, length / part.hair.length)));
        }
        part.hair.length = length;
        if (method == Method::Equilibrium) continue;
        // The walk knows straight hair only.
        part.hair.taper = 0;
        part.hair.curl.reset();
        part.hair.wave.reset();
        part.ties.clear();
    }
    return other;
}

bool winds(const Style& style) {
    return style.parts[0].hair.curl || style.parts[0].hair.wave;
}

// The rays and triangles do find hair in the head: where nothing keeps it out, and by how much.
TEST(SolidHead, IsFoundOut) {
    EXPECT_TRUE(solidHead().contains({0, 0, 0}));
    EXPECT_FALSE(solidHead().contains({0, 0.2, 0}));
    const std::array<Vec3f, 3> through = {Vec3f{0, 0.2F, 0}, Vec3f{0, 0.05F, 0}, Vec3f{0, 0, 0}};
    EXPECT_GT(solidHead().depth(through), 0.03);
    const std::array<Vec3f, 2> above = {Vec3f{0, 0.2F, 0}, Vec3f{0.2F, 0.2F, 0}};
    EXPECT_EQ(solidHead().depth(above), 0);
    // Aslant through the tip of the nose, between two nodes outside.
    const Vec3d tip = std::ranges::max_element(head().vertices, {}, [](Vec3f v) {
                          return std::abs(v.y) < 0.1F ? v.x : 0;
                      })->as<double>();
    const std::array<Vec3f, 2> pierced = {(tip + Vec3d{-0.003, 0, 0.1}).as<float>(),
                                          (tip + Vec3d{-0.003, 0, -0.1}).as<float>()};
    EXPECT_GT(solidHead().depth(pierced), 1e-4);
    Style free = *readStyle(std::string(KUSHI_SOURCE_DIR) + "/styles/fig09b-gravity.toml");
    free.headCollides = false;
    const auto groom = settle(trimmed(free, Method::Equilibrium, 0.5, {0, -1, 0}), {});
    ASSERT_TRUE(groom.ok());
    EXPECT_GT(solidHead().find(groom->strands).strands, strands / 3);
}

// What is pushed out as far as the field may be wrong is out of the triangles.
TEST(SolidHead, IsWhereItsFieldSaysWithinTheMargin) {
    const Solid solid = {head(), 0};
    const DistanceField field = *distanceFieldOf({&solid, 1}, {});
    const auto at = [](std::uint32_t vertex) { return head().vertices[vertex]; };
    float outside = 0;
    float inside = 0;
    for (const auto& [a, b, c] : head().triangles) {
        for (const Vec3f place :
             {at(a), (1 / 3.0F) * (at(a) + at(b) + at(c)), 0.5F * (at(a) + at(b)),
              0.5F * (at(b) + at(c)), 0.5F * (at(c) + at(a))}) {
            outside = std::max(outside, distanceAt(field, place));
            inside = std::min(inside, distanceAt(field, place));
        }
    }
    std::printf("the field says up to %.3f mm outside and %.3f mm inside\n", 1e3F * outside,
                -1e3F * inside);
    EXPECT_LT(outside, marginOf(field));
}

class ShippedStyle : public testing::TestWithParam<std::string> {};

// Whatever the length, the pull and the method: no hair goes through head, neck or shoulders, not
// even between its nodes.
TEST_P(ShippedStyle, LeavesTheHeadAlone) {
    const auto style = readStyle(std::string(KUSHI_SOURCE_DIR) + "/styles/" + GetParam() + ".toml");
    ASSERT_TRUE(style.ok());
    SettleOptions options;
    options.cacheFolder = test::fieldCache();
    int which = 0;
    for (const double length : {0.1, 0.25, 0.5, 0.9}) {
        // Long curls take long.
        if (winds(*style) && length > 0.3) continue;
        for (const auto& [name, way] : gravities) {
            ++which;
            for (const Method method : {Method::Cantilever, Method::Equilibrium}) {
                // Half of the rests: against a style's own forces they take long.
                if (method == Method::Equilibrium && which % 2 == 0) continue;
                const auto groom = settle(trimmed(*style, method, length, way), options);
                ASSERT_TRUE(groom.ok());
                const test::HairInMesh found = solidHead().find(groom->strands);
                EXPECT_EQ(found.strands, 0U)
                    << length << " m, " << name << ": " << 1e3 * found.deepest << " mm at "
                    << found.place.x << ' ' << found.place.y << ' ' << found.place.z;
                EXPECT_EQ(groom->report.stuck, 0U) << length << " m, " << name;
            }
        }
    }
}

// As it is, with more hairs.
TEST_P(ShippedStyle, IsOutOfTheHead) {
    const auto style = readStyle(std::string(KUSHI_SOURCE_DIR) + "/styles/" + GetParam() + ".toml");
    ASSERT_TRUE(style.ok());
    SettleOptions options;
    options.cacheFolder = test::fieldCache();
    options.count = 100 * strands;
    const auto groom = settle(*style, options);
    ASSERT_TRUE(groom.ok());
    const test::HairInMesh found = solidHead().find(groom->strands);
    EXPECT_EQ(found.strands, 0U) << 1e3 * found.deepest << " mm at " << found.place.x << ' '
                                 << found.place.y << ' ' << found.place.z;
    EXPECT_EQ(groom->report.stuck, 0U);
}

// None is left out.
std::vector<std::string> allStyles() {
    std::vector<std::string> names;
    for (const auto& entry :
         std::filesystem::directory_iterator(std::string(KUSHI_SOURCE_DIR) + "/styles")) {
        if (entry.path().extension() == ".toml") names.push_back(entry.path().stem());
    }
    std::ranges::sort(names);
    return names;
}

INSTANTIATE_TEST_SUITE_P(Solids, ShippedStyle, testing::ValuesIn(allStyles()),
                         [](const auto& style) {
                             std::string name = style.param;
                             std::erase(name, '-');
                             return name;
                         });

}  // namespace
}  // namespace kushi
