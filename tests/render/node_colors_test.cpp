// SPDX-License-Identifier: Apache-2.0
//
// Colours that are made when a picture asks for them.
#include "render/test_scene.h"

#include <algorithm>
#include <cstring>
#include <mutex>
#include <random>
#include <set>

#include <gmock/gmock.h>

namespace kushi {
namespace {

using namespace test;

/// Strands in a heap, with colours, widths and a wall that hides some of them.
struct Heap {
    Hairs hairs;
    Mesh wall;

    Heap() {
        std::mt19937 random(7);
        std::uniform_real_distribution<float> place(-40, 40);
        std::uniform_real_distribution<float> shade(0, 1);
        for (int i = 0; i < 900; ++i) {
            std::vector<Vec3f> nodes;
            std::vector<Rgb> colors;
            Vec3f at = {place(random), place(random), place(random) / 4};
            for (int j = 0; j < 12; ++j) {
                nodes.push_back(at);
                colors.push_back({shade(random), shade(random), shade(random)});
                at = at + Vec3f{place(random), place(random), place(random)} * 0.1F;
            }
            hairs.add(nodes, colors);
        }
        hairs.strands.diameters.assign(hairs.colors.size(), 1.3F);
        addRectangle(wall, {-40, -30, 1}, {40, 40, 1}, red);
    }
};

class NodeColorsOf : public testing::TestWithParam<Stroke> {};

TEST_P(NodeColorsOf, MakeTheSamePictureOnceAndAscending) {
    const Heap heap;
    for (const int threads : {1, 3}) {
        const DrawOptions options = {.width = 130,
                                     .height = 100,
                                     .supersample = 2,
                                     .background = black,
                                     .threads = threads,
                                     .stroke = GetParam()};
        std::mutex lock;
        std::set<std::uint32_t> asked;
        bool ascending = true;
        const NodeColors colors = [&](std::span<const std::uint32_t> nodes, std::span<Rgb> wanted) {
            ASSERT_EQ(nodes.size(), wanted.size());
            const std::scoped_lock hold(lock);
            ascending = ascending && std::ranges::is_sorted(nodes, std::less_equal<>());
            asked.insert(nodes.begin(), nodes.end());
            for (std::size_t i = 0; i < nodes.size(); ++i)
                wanted[i] = heap.hairs.colors[nodes[i]];
        };
        const Camera camera = pixelCamera(options.height);
        const Image made = draw(heap.hairs.strands, colors, heap.wall, camera, options);
        const Image known = draw(heap.hairs.strands, heap.hairs.colors, heap.wall, camera, options);
        ASSERT_EQ(made.pixels.size(), known.pixels.size());
        EXPECT_EQ(
            std::memcmp(made.pixels.data(), known.pixels.data(), made.pixels.size() * sizeof(Rgb)),
            0);
        EXPECT_TRUE(ascending);
        // What is behind the wall or outside of the picture is not asked for.
        EXPECT_GT(asked.size(), heap.hairs.colors.size() / 10);
        EXPECT_LT(asked.size(), heap.hairs.colors.size() * 3 / 4);

        const Layers layers = {.depth = true, .mask = true};
        const LayeredImage one =
            drawLayers(heap.hairs.strands, colors, heap.wall, camera, options, layers);
        const LayeredImage other =
            drawLayers(heap.hairs.strands, heap.hairs.colors, heap.wall, camera, options, layers);
        EXPECT_EQ(one.image.pixels, other.image.pixels);
        EXPECT_EQ(one.alpha, other.alpha);
    }
}

INSTANTIATE_TEST_SUITE_P(Strokes, NodeColorsOf,
                         testing::Values(Stroke::Line, Stroke::Sampled, Stroke::Analytic));

}  // namespace
}  // namespace kushi
