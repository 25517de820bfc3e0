// SPDX-License-Identifier: Apache-2.0
#include "pipeline/dress.h"

#include "core/random.h"
#include "pipeline/clumps.h"
#include "pipeline/flyaway.h"

#include <kushi/strands.h>

#include <algorithm>
#include <cmath>
#include <map>
#include <utility>

#include <gtest/gtest.h>

namespace kushi {
namespace {

constexpr double side = 0.1;      // of the patch of scalp [m]
constexpr double longHair = 0.2;  // m
constexpr int segments = 20;
constexpr Vec3d middle = {-0.05, 0.1, -0.05};  // of the head

// Random places on a square, and their keys.
struct Field {
    std::vector<Vec3d> roots;
    std::vector<std::uint64_t> keys;

    explicit Field(std::size_t count) {
        for (std::uint64_t i = 0; i < count; ++i) {
            roots.push_back({side * uniform(3 * i), 0, side * uniform(3 * i + 1)});
            keys.push_back(scramble(i));
        }
    }
};

// A curtain of hair; `lean` says by how much it goes along x, by where it grows.
template <class Lean>
Strands curtain(const Field& scalp, Lean lean) {
    Strands hair;
    for (std::size_t i = 0; i < scalp.roots.size(); ++i) {
        const Vec3d way = normalized(Vec3d{lean(scalp.roots[i]), -1, 0});
        std::vector<Vec3f> nodes;
        for (int j = 0; j <= segments; ++j)
            nodes.push_back((scalp.roots[i] + j * longHair / segments * way).as<float>());
        hair.add(nodes, scalp.keys[i]);
    }
    return hair;
}

Strands curtain(const Field& scalp) {
    return curtain(scalp, [](Vec3d) { return 0.0; });
}

struct Dressed {
    Strands hair;
    DressReport report;
};

Dressed dressed(const Field& scalp, Strands strands, const Hair& hair, int threads = 0) {
    const ClumpCentres centres = hair.clump.amount > 0
                                     ? ClumpCentres(scalp.roots, scalp.keys, hair.clump.size)
                                     : ClumpCentres();
    StrandsAtRest atRest = {{}, strands.keys};
    for (std::size_t i = 0; i < strands.size(); ++i)
        atRest.strands.push_back(strands.strand(i));
    const DressReport report = dress(hair, centres, middle, {}, atRest, threads);
    return {std::move(strands), report};
}

Hair clumped(double amount, double size) {
    Hair hair;
    hair.clump.amount = amount;
    hair.clump.size = size;
    hair.clump.variation = 0;
    return hair;
}

// The centre that a place is nearest to.
std::uint32_t nearestTo(const ClumpCentres& centres, Vec3d place) {
    std::uint32_t best = 0;
    for (std::uint32_t i = 1; i < centres.size(); ++i)
        if (length(centres.point(i) - place) < length(centres.point(best) - place)) best = i;
    return best;
}

// A strand's clump, and the strand in the middle of that.
struct Clumps {
    ClumpCentres centres;
    std::vector<std::size_t> guides;

    Clumps(const Field& scalp, double size) : centres(scalp.roots, scalp.keys, size) {
        for (std::uint32_t i = 0; i < centres.size(); ++i) {
            const auto found = std::ranges::find(scalp.keys, centres.key(i));
            guides.push_back(static_cast<std::size_t>(found - scalp.keys.begin()));
        }
    }
    std::size_t guideOf(Vec3d root) const { return guides[nearestTo(centres, root)]; }
};

// Of two strands' nodes.
double apart(const Strands& hair, std::size_t i, std::size_t k, std::size_t node) {
    return double{length(hair.strand(i)[node] - hair.strand(k)[node])};
}

TEST(ClumpCentres, AreSpreadAsFarApartAsAsked) {
    const Field scalp(20000);
    const double size = 0.008;
    const ClumpCentres centres(scalp.roots, scalp.keys, size);
    const double expected = side * side / (size * size);
    EXPECT_NEAR(static_cast<double>(centres.size()) / expected, 1, 0.15);
    for (std::uint32_t i = 0; i < centres.size(); ++i)
        for (std::uint32_t j = 0; j < i; ++j)
            EXPECT_GE(length(centres.point(i) - centres.point(j)), 0.83 * size);
    for (const Vec3d root : scalp.roots) {
        EXPECT_LT(length(root - centres.point(nearestTo(centres, root))), 0.83 * size);
        const auto around = centres.around(root);
        for (std::uint32_t i = 0; i < centres.size(); ++i) {
            if (length(root - centres.point(i)) > 1.66 * size) continue;
            EXPECT_TRUE(std::ranges::binary_search(around, i));
        }
    }
}

TEST(ClumpCentres, DoNotDependOnTheOrderOfTheRoots) {
    Field scalp(3000);
    const ClumpCentres one(scalp.roots, scalp.keys, 0.01);
    std::ranges::reverse(scalp.roots);
    std::ranges::reverse(scalp.keys);
    const ClumpCentres other(scalp.roots, scalp.keys, 0.01);
    ASSERT_EQ(one.size(), other.size());
    for (std::uint32_t i = 0; i < one.size(); ++i) {
        EXPECT_EQ(one.key(i), other.key(i));
        EXPECT_EQ(one.point(i), other.point(i));
    }
}

TEST(Clump, TipsGoTheAskedShareOfTheWayAndRootsStay) {
    const Field scalp(4000);
    const Strands before = curtain(scalp);
    for (const double amount : {0.3, 0.6}) {
        const auto [after, report] = dressed(scalp, before, clumped(amount, 0.01));
        const Clumps clumps(scalp, 0.01);
        EXPECT_EQ(report.clumps, clumps.guides.size());
        EXPECT_EQ(report.flyaways, 0U);
        double was = 0;
        double became = 0;
        double halfway = 0;
        for (std::size_t i = 0; i < after.size(); ++i) {
            ASSERT_EQ(after.strand(i)[0], before.strand(i)[0]);
            const std::size_t guide = clumps.guideOf(scalp.roots[i]);
            was += apart(after, i, guide, 0);
            became += apart(after, i, guide, segments);
            halfway += apart(after, i, guide, segments / 2);
        }
        EXPECT_NEAR(became / was, 1 - amount, 0.02);
        // At 0.5 the step from 0.1 to 1 has come to t^2 (3 - 2 t) at t = 4/9.
        EXPECT_NEAR(halfway / was, 1 - amount * 0.4170, 0.02);
    }
}

TEST(Clump, KeepsEverySegmentsLength) {
    const Field scalp(2000);
    const Strands before = curtain(scalp, [](Vec3d root) { return 3 * root.z; });
    const Strands after = dressed(scalp, before, clumped(0.9, 0.02)).hair;
    EXPECT_NE(after.nodes, before.nodes);
    for (std::size_t i = 0; i < after.size(); ++i) {
        for (std::size_t j = 1; j <= segments; ++j) {
            const auto size = [&](const Strands& hair) {
                return double{length(hair.strand(i)[j] - hair.strand(i)[j - 1])};
            };
            EXPECT_NEAR(size(after) / size(before), 1, 1e-4);
        }
        EXPECT_NEAR(polylineLength(after.strand(i)), longHair, 2e-7);
    }
}

TEST(Clump, LeavesRoomForEveryHair) {
    const Field scalp(4000);
    Hair hair = clumped(0.9, 0.01);
    hair.diameter = 2e-4;
    const Strands after = dressed(scalp, curtain(scalp), hair).hair;
    const Clumps clumps(scalp, 0.01);
    for (std::size_t i = 0; i < after.size(); ++i) {
        const std::size_t guide = clumps.guideOf(scalp.roots[i]);
        EXPECT_GE(apart(after, i, guide, segments),
                  0.99 * std::min(apart(after, i, guide, 0), 2 * hair.diameter));
    }
}

TEST(Clump, DiffersFromClumpToClump) {
    const Field scalp(4000);
    Hair hair = clumped(0.5, 0.01);
    hair.clump.variation = 0.5;
    const Strands after = dressed(scalp, curtain(scalp), hair).hair;
    const Clumps clumps(scalp, 0.01);
    std::map<std::size_t, std::pair<double, double>> sums;
    for (std::size_t i = 0; i < after.size(); ++i) {
        const std::size_t guide = clumps.guideOf(scalp.roots[i]);
        sums[guide].first += apart(after, i, guide, 0);
        sums[guide].second += apart(after, i, guide, segments);
    }
    double least = 1;
    double most = 0;
    for (const auto& [guide, sum] : sums) {
        if (sum.first == 0) continue;
        least = std::min(least, 1 - sum.second / sum.first);
        most = std::max(most, 1 - sum.second / sum.first);
    }
    EXPECT_LT(least, 0.33);
    EXPECT_GT(least, 0.2);
    EXPECT_GT(most, 0.67);
    EXPECT_LT(most, 0.8);
}

// Whole clumps go their own ways, a little, and outwards rather than inwards.
TEST(Clump, StraysAsAWhole) {
    const Field scalp(4000);
    const Strands before = curtain(scalp);
    const Strands after = dressed(scalp, before, clumped(0.6, 0.01)).hair;
    const Clumps clumps(scalp, 0.01);
    double farthest = 0;
    Vec3d mean;
    for (const std::size_t guide : clumps.guides) {
        for (std::size_t j = 0; j <= segments; ++j) {
            const Vec3d off = (after.strand(guide)[j] - before.strand(guide)[j]).as<double>();
            const double size = std::hypot(off.x, off.z);
            // Outwards and to one side by 0.3 of the size each; not before a tenth of the length.
            EXPECT_LE(size, std::sqrt(2) * 0.5 * 0.6 * 0.01 + 2e-4);
            if (j <= segments / 10) {
                EXPECT_LT(size, 1e-7);
            }
            farthest = std::max(farthest, size);
            mean += off;
        }
    }
    EXPECT_GT(farthest, 0.5 * 0.6 * 0.01);
    EXPECT_GT(mean.x, 0);
    EXPECT_GT(mean.z, 0);
}

// At a parting each side keeps to itself, though the roots are neighbours.
TEST(Clump, DoesNotReachAcrossAParting) {
    const Field scalp(4000);
    const auto sideways = [](Vec3d root) { return root.x > side / 2 ? 1.0 : -1.0; };
    const Strands before = curtain(scalp, sideways);
    const Strands after = dressed(scalp, before, clumped(0.8, 0.01)).hair;
    double moved = 0;
    for (std::size_t i = 0; i < after.size(); ++i) {
        const float by = length(after.strand(i).back() - before.strand(i).back());
        EXPECT_LT(by, 0.8 * (1.66 + 1) * 0.01) << i;
        if (std::abs(scalp.roots[i].x - side / 2) < 0.003) moved += double{by};
    }
    EXPECT_GT(moved, 0);
}

TEST(Flyaway, AreAsManyAsAskedAndTheOthersStay) {
    const Field scalp(20000);
    const Strands before = curtain(scalp);
    Hair hair;
    hair.flyaway.share = 0.02;
    const auto [after, report] = dressed(scalp, before, hair);
    // Four standard deviations.
    EXPECT_NEAR(static_cast<double>(report.flyaways), 400, 4 * std::sqrt(400 * 0.98));
    std::size_t changed = 0;
    for (std::size_t i = 0; i < after.size(); ++i) {
        const bool same = std::ranges::equal(after.strand(i), before.strand(i));
        EXPECT_EQ(same, !isFlyaway(hair.flyaway, scalp.keys[i]));
        changed += same ? 0 : 1;
    }
    EXPECT_EQ(changed, report.flyaways);
}

TEST(Flyaway, StandOffSmoothlyAndAreALittleShorter) {
    const Field scalp(500);
    const Strands before = curtain(scalp);
    Hair hair;
    hair.flyaway = {1, 0.02};
    const Strands after = dressed(scalp, before, hair).hair;
    double most = 0;
    for (std::size_t i = 0; i < after.size(); ++i) {
        const auto nodes = after.strand(i);
        EXPECT_EQ(nodes[0], before.strand(i)[0]);
        const double whole = polylineLength(nodes);
        EXPECT_LE(whole, longHair * (1 + 1e-6));
        EXPECT_GE(whole, longHair * 0.7 * (1 - 1e-6));
        const Vec3d tip = nodes.back().as<double>() - nodes[0].as<double>();
        // Away from the middle of the head.
        const Vec3d outward = normalized(Vec3d{nodes[0].x - middle.x, 0, nodes[0].z - middle.z});
        EXPECT_GT(dot(tip, outward), 0);
        most = std::max(most, std::hypot(tip.x, tip.z));
        for (std::size_t j = 2; j < nodes.size(); ++j) {
            const Vec3f a = normalized(nodes[j] - nodes[j - 1]);
            const Vec3f b = normalized(nodes[j - 1] - nodes[j - 2]);
            EXPECT_LT(length(a - b), 0.2F);
        }
    }
    EXPECT_GT(most, 0.02);
    EXPECT_LT(most, 0.045);
}

TEST(Dress, IsTheSameFromAnyNumberOfThreads) {
    const Field scalp(3000);
    Hair hair = clumped(0.5, 0.01);
    hair.flyaway.share = 0.1;
    const Strands before = curtain(scalp, [](Vec3d root) { return 2 * root.x; });
    const Dressed one = dressed(scalp, before, hair, 1);
    const Dressed many = dressed(scalp, before, hair, 5);
    EXPECT_EQ(one.hair.nodes, many.hair.nodes);
    EXPECT_EQ(one.report.clumps, many.report.clumps);
    EXPECT_EQ(one.report.flyaways, many.report.flyaways);
}

}  // namespace
}  // namespace kushi
