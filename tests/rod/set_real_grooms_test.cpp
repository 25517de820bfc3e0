// SPDX-License-Identifier: Apache-2.0
//
// Grooms made by others, as hair that stays where it is. They are not part of Kushi;
// KUSHI_TEST_DATA names their folder.
#include <kushi/groom_io.h>
#include <kushi/rest_shape.h>

#include <algorithm>
#include <cstdio>
#include <cstdlib>
#include <filesystem>

#include <gtest/gtest.h>

namespace kushi {
namespace {

// Files are in their makers' units and axes.
struct RealGroom {
    const char* name;
    float unit;  // cm
    Vec3d down;
};

void PrintTo(const RealGroom& groom, std::ostream* out) {
    *out << groom.name;
}

class RealGrooms : public testing::TestWithParam<RealGroom> {};

TEST_P(RealGrooms, StayPutAndComeBackFromALittleMoreLoad) {
    const char* folder = std::getenv("KUSHI_TEST_DATA");
    if (folder == nullptr) GTEST_SKIP() << "KUSHI_TEST_DATA names no folder of sample grooms";
    const auto& [name, unit, down] = GetParam();
    const std::string path = std::filesystem::path(folder) / name;
    if (!std::filesystem::exists(path)) GTEST_SKIP() << path << " is not there";
    Strands groom = *readGroom(path);
    for (Vec3f& node : groom.nodes)
        node *= unit;
    RodWorld world;
    world.gravity = down;
    const SetGroom set = *restShapeOf(groom, materialsOf(groom, Hair()), world);

    std::vector<float> factors = set.factors;
    std::sort(factors.begin(), factors.end());
    const auto stiffened = std::upper_bound(factors.begin(), factors.end(), 1.0F);
    std::printf("%s: %zu strands, %zu unstable, %zu stiffened, %zu beyond", name, groom.size(),
                set.unstable.size(), static_cast<std::size_t>(factors.end() - stiffened),
                set.unheld.size());
    if (stiffened != factors.end()) {
        std::printf(", by %.3g in the median, %.3g at 95 %%, %.3g at most",
                    *(stiffened + (factors.end() - stiffened) / 2),
                    *(stiffened + (factors.end() - stiffened) * 95 / 100), factors.back());
    }
    std::printf("\n");

    RestState state;
    std::vector<Vec3f> nodes(set.rods.nodeCount());
    std::vector<Vec3f> placed(groom.nodes.size());
    RestOptions options;
    const auto farthest = [&] {
        placeNodes(set, nodes, placed);
        double most = 0;
        for (std::size_t i = 0; i < groom.size(); ++i) {
            const double whole = std::max(polylineLength(groom.strand(i)), 1e-6);
            for (std::size_t j = groom.offsets[i]; j < groom.offsets[i + 1]; ++j)
                most =
                    std::max(most, static_cast<double>(length(placed[j] - groom.nodes[j])) / whole);
        }
        return most;
    };
    const RestReport first = settleRods(set.rods, world, state, nodes, options);
    EXPECT_TRUE(first.unsettled.empty());
    std::printf("%s: settled again, nodes moved by %.2g of the length at most, %zu refined\n", name,
                farthest(), first.refined);
    EXPECT_LT(farthest(), 1e-4);
    options.warm = true;
    RodWorld heavier;
    heavier.gravity = 1.01 * down;
    EXPECT_TRUE(settleRods(set.rods, heavier, state, nodes, options).unsettled.empty());
    std::printf("%s: 1 %% more load moves them by %.2g", name, farthest());
    EXPECT_TRUE(settleRods(set.rods, world, state, nodes, options).unsettled.empty());
    std::printf(", and back to within %.2g\n", farthest());
    EXPECT_LT(farthest(), 1e-3);
}

INSTANTIATE_TEST_SUITE_P(Files, RealGrooms,
                         testing::Values(RealGroom{"Bangs_100.hair", 0.1F, {-1, 0, 0}},
                                         RealGroom{"Bangs_100_ascii.ply", 0.1F, {-1, 0, 0}},
                                         RealGroom{"Bangs_100_binary.ply", 0.1F, {-1, 0, 0}},
                                         RealGroom{"straight.hair", 0.36F, {0, 0, -1}}));

}  // namespace
}  // namespace kushi
