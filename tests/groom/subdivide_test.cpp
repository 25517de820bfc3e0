// SPDX-License-Identifier: Apache-2.0
#include <kushi/subdivide.h>

#include <cmath>
#include <numbers>
#include <random>

#include <gmock/gmock.h>

namespace kushi {
namespace {

using testing::ElementsAre;

constexpr double quarter = 0.066;  // rad

/// A helix of 3 cm radius, with nodes at the angles given [rad].
std::vector<Vec3f> helix(const std::vector<double>& angles) {
    std::vector<Vec3f> nodes;
    for (const double a : angles) {
        nodes.push_back(Vec3d{0.03 * std::cos(a), 0.01 * a, 0.03 * std::sin(a)}.as<float>());
    }
    return nodes;
}

std::vector<double> upTo(double end, int count) {
    std::vector<double> angles;
    for (int i = 0; i < count; ++i)
        angles.push_back(end * i / (count - 1));
    return angles;
}

/// The largest angle between successive segments.
double sharpest(std::span<const Vec3f> nodes) {
    double most = 0;
    for (std::size_t i = 2; i < nodes.size(); ++i) {
        const Vec3d a = nodes[i - 1].as<double>() - nodes[i - 2].as<double>();
        const Vec3d b = nodes[i].as<double>() - nodes[i - 1].as<double>();
        most = std::max(most, std::atan2(length(cross(a, b)), dot(a, b)));
    }
    return most;
}

TEST(Subdivided, TurnsNoMoreThanAskedFor) {
    Strands strands;
    strands.add(helix(upTo(0.5 * std::numbers::pi, 17)), 1);  // 5.6 degrees a segment
    strands.add(helix(upTo(6, 17)), 2);
    // And with segments of all lengths.
    std::mt19937 random(1);
    std::uniform_real_distribution<double> step(0.05, 0.5);
    std::vector<double> angles = {0};
    while (angles.size() < 30)
        angles.push_back(angles.back() + step(random));
    strands.add(helix(angles), 3);

    const Strands finer = subdivided(strands, quarter);
    ASSERT_EQ(finer.size(), 3U);
    EXPECT_LT(sharpest(finer.strand(0)), 1.05 * quarter);
    EXPECT_LT(sharpest(finer.strand(1)), 1.05 * quarter);
    EXPECT_LT(sharpest(finer.strand(2)), 1.2 * quarter);
    EXPECT_EQ(finer.strand(0).size(), 33U);
}

TEST(Subdivided, LiesOnTheCurve) {
    Strands strands;
    strands.add(helix(upTo(6, 25)), 1);
    const auto off = [](Vec3f node) { return std::abs(std::hypot(node.x, node.z) - 0.03); };
    const Strands finer = subdivided(strands, 0.02);
    double most = 0;
    for (const Vec3f node : finer.nodes)
        most = std::max(most, off(node));
    // A chord's middle is 0.03 (1 - cos 0.125) = 0.23 mm off.
    EXPECT_LT(most, 0.02e-3);
}

TEST(Subdivided, KeepsEveryNode) {
    Strands strands;
    strands.add(helix(upTo(6, 9)), 5);
    strands.add(helix({1}), 6);
    strands.add(helix({1, 3}), 7);
    strands.diameters.assign(strands.nodes.size(), 80e-6F);
    const Strands finer = subdivided(strands, quarter);
    EXPECT_EQ(finer.keys, strands.keys);
    for (std::size_t i = 0; i < strands.size(); ++i) {
        auto next = finer.strand(i).begin();
        for (const Vec3f node : strands.strand(i)) {
            next = std::find(next, finer.strand(i).end(), node);
            ASSERT_NE(next, finer.strand(i).end());
        }
        EXPECT_EQ(finer.strand(i).front(), strands.strand(i).front());
        EXPECT_EQ(finer.strand(i).back(), strands.strand(i).back());
    }
    EXPECT_GT(finer.strand(0).size(), 50U);
    EXPECT_EQ(finer.strand(1).size(), 1U);
    EXPECT_EQ(finer.strand(2).size(), 2U);
}

TEST(Subdivided, LeavesStraightStrandsAlone) {
    Strands strands;
    strands.add(std::vector<Vec3f>{{0, 0, 0}, {0, -0.01F, 0}, {0, -0.05F, 0}, {0, -0.06F, 0}}, 1);
    EXPECT_EQ(subdivided(strands, quarter).nodes, strands.nodes);
    EXPECT_EQ(subdivided({}, quarter).size(), 0U);
}

TEST(Subdivided, MixesAttributesLinearly) {
    Strands strands;
    strands.add(std::vector<Vec3f>{{0, 0, 0}, {0.01F, 0, 0}, {0.01F, 0.01F, 0}}, 1);
    strands.diameters = {80e-6F, 40e-6F, 0};
    strands.transparency = {0, 0.5F, 1};
    strands.colors = {{1, 0, 0}, {0, 1, 0}, {0, 1, 1}};
    const Strands finer = subdivided(strands, radians(46));
    // The end parabolas turn by 90 degrees in all over each segment: two parts.
    ASSERT_EQ(finer.nodes.size(), 5U);
    EXPECT_THAT(finer.diameters, ElementsAre(80e-6F, 60e-6F, 40e-6F, 20e-6F, 0));
    EXPECT_THAT(finer.transparency, ElementsAre(0, 0.25F, 0.5F, 0.75F, 1));
    EXPECT_EQ(finer.colors[1], (Rgb{0.5F, 0.5F, 0}));
}

TEST(Subdivided, LeavesNonsenseWhole) {
    Strands strands;
    strands.add(std::vector<Vec3f>{{0, 0, 0}, {0, 0, 0}, {0.01F, 0, 0}, {NAN, 0, 0}, {0, 1, 0}}, 1);
    const Strands finer = subdivided(strands, quarter);
    EXPECT_EQ(finer.nodes.size(), 5U);
    EXPECT_EQ(finer.nodes[2], strands.nodes[2]);
}

TEST(Subdivided, DoesNotDependOnThreads) {
    Strands strands;
    for (int i = 0; i < 2000; ++i)
        strands.add(helix(upTo(0.003 * i, 12)), static_cast<std::uint64_t>(i));
    EXPECT_EQ(subdivided(strands, quarter, 1).nodes, subdivided(strands, quarter, 5).nodes);
}

}  // namespace
}  // namespace kushi
