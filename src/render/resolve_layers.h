// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "render/scene.h"
#include "render/tile.h"
#include "render/tiles.h"

#include <kushi/layered_image.h>

#include <vector>

namespace kushi {

/// Fills a tile's part of the layers that an image has room for, from what its samples show.
class LayerResolver {
public:
    LayerResolver(const Scene& scene, int supersample, LayeredImage& layers)
        : scene_(scene), supersample_(supersample), layers_(layers) {}

    /// samples  with the ids of Palette
    void operator()(const SampleTile& samples, const TileItems& items);

private:
    /// What is known of a segment.
    struct Hair {
        std::uint32_t strand = LayeredImage::noStrand;
        Vec3f tangent;  // 0 if the segment has no length
    };
    /// How many of a pixel's samples show a strand.
    struct Vote {
        std::uint32_t strand;
        int samples;
        SampleTile::Key nearest;
    };

    void resolvePixel(const SampleTile& samples, const TileItems& items, int x, int y,
                      std::size_t pixel);
    const Hair& hair(std::uint32_t id, const TileItems& items);

    const Scene& scene_;
    int supersample_;
    LayeredImage& layers_;
    std::vector<Hair> hairs_;  // by id, once asked for
    std::vector<Vote> votes_;
};

}  // namespace kushi
