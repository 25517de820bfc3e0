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

class RealGrooms : public testing::TestWithParam<const char*> {};

TEST_P(RealGrooms, StayPutAndComeBackFromALittleMoreLoad) {
    const char* folder = std::getenv("KUSHI_TEST_DATA");
    if (folder == nullptr) GTEST_SKIP() << "KUSHI_TEST_DATA names no folder of sample grooms";
    const std::string path = std::filesystem::path(folder) / GetParam();
    if (!std::filesystem::exists(path)) GTEST_SKIP() << path << " is not there";
    const Strands groom = *readGroom(path);
    Hair hair;
    const SetGroom set = *restShapeOf(groom, materialsOf(groom, hair), {});

    std::vector<float> factors = set.factors;
    std::sort(factors.begin(), factors.end());
    const auto stiffened = std::upper_bound(factors.begin(), factors.end(), 1.0F);
    std::printf("%s: %zu strands, %zu unstable, %zu stiffened, %zu beyond", GetParam(),
                groom.size(), set.unstable.size(),
                static_cast<std::size_t>(factors.end() - stiffened), set.unheld.size());
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
    const RestReport first = settleRods(set.rods, {}, state, nodes, options);
    EXPECT_TRUE(first.unsettled.empty());
    std::printf("%s: settled again, nodes moved by %.2g of the length at most, %zu refined\n",
                GetParam(), farthest(), first.refined);
    EXPECT_LT(farthest(), 1e-4);
    options.warm = true;
    RodWorld heavier;
    heavier.gravity = {0, -1.01, 0};
    EXPECT_TRUE(settleRods(set.rods, heavier, state, nodes, options).unsettled.empty());
    std::printf("%s: 1 %% more load moves them by %.2g", GetParam(), farthest());
    EXPECT_TRUE(settleRods(set.rods, {}, state, nodes, options).unsettled.empty());
    std::printf(", and back to within %.2g\n", farthest());
    EXPECT_LT(farthest(), 1e-3);
}

INSTANTIATE_TEST_SUITE_P(Files, RealGrooms,
                         testing::Values("Bangs_100.hair", "Bangs_100_ascii.ply",
                                         "Bangs_100_binary.ply", "straight.hair"));

}  // namespace
}  // namespace kushi
