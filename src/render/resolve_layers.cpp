// SPDX-License-Identifier: Apache-2.0
#include "render/resolve_layers.h"

#include <algorithm>

namespace kushi {

void LayerResolver::operator()(const SampleTile& samples, const TileItems& items) {
    hairs_.assign(items.segments.size() + 1, {});
    const int left = samples.x() / supersample_;
    const int top = samples.y() / supersample_;
    const int columns = std::min(samples.size() / supersample_, layers_.image.width - left);
    const int rows = std::min(samples.size() / supersample_, layers_.image.height - top);
    for (int y = 0; y < rows; ++y) {
        const std::size_t row =
            static_cast<std::size_t>(top + y) * static_cast<std::size_t>(layers_.image.width);
        for (int x = 0; x < columns; ++x) {
            resolvePixel(samples, items, x * supersample_, y * supersample_,
                         row + static_cast<std::size_t>(left + x));
        }
    }
}

void LayerResolver::resolvePixel(const SampleTile& samples, const TileItems& items, int x, int y,
                                 std::size_t pixel) {
    votes_.clear();
    SampleTile::Key nearest = SampleTile::Key{1} << 62;
    SampleTile::Key nearestHair = nearest;
    Vec3f sum;
    int things = 0;
    int hairs = 0;
    for (int i = 0; i < supersample_ * supersample_; ++i) {
        const SampleTile::Key key = *samples.at(x + i % supersample_, y + i / supersample_);
        const std::uint32_t id = SampleTile::id(key);
        if (id == 0) continue;
        ++things;
        nearest = std::min(nearest, key);
        if (id > items.segments.size()) continue;
        ++hairs;
        const Hair& seen = hair(id, items);
        sum += seen.tangent;
        const auto vote = std::find_if(votes_.begin(), votes_.end(), [&](const Vote& other) {
            return other.strand == seen.strand;
        });
        if (vote == votes_.end()) {
            votes_.push_back({seen.strand, 1, key});
        } else {
            ++vote->samples;
            vote->nearest = std::min(vote->nearest, key);
        }
        nearestHair = std::min(nearestHair, key);
    }
    if (things == 0) return;

    const auto all = static_cast<float>(supersample_ * supersample_);
    layers_.alpha[pixel] = static_cast<float>(things) / all;
    if (!layers_.mask.empty()) layers_.mask[pixel] = static_cast<float>(hairs) / all;
    if (!layers_.depth.empty()) {
        layers_.depth[pixel] = static_cast<float>(1 / scene_.projection().inverseDistance(nearest));
    }
    if (hairs == 0) return;
    const Hair& front = hair(SampleTile::id(nearestHair), items);
    if (!layers_.strand.empty()) {
        const auto most =
            std::min_element(votes_.begin(), votes_.end(), [](const Vote& a, const Vote& b) {
                return a.samples != b.samples ? a.samples > b.samples : a.nearest < b.nearest;
            });
        layers_.strand[pixel] = most->strand;
    }
    if (!layers_.tangent.empty()) {
        const float size = length(sum);
        layers_.tangent[pixel] = size > 1e-3F ? sum / size : front.tangent;
    }
}

const LayerResolver::Hair& LayerResolver::hair(std::uint32_t id, const TileItems& items) {
    Hair& known = hairs_[id];
    if (known.strand != LayeredImage::noStrand) return known;
    const std::uint32_t node = items.segments[id - 1];
    const auto& nodes = scene_.strands().nodes;
    const Vec3d along = nodes[node + 1].as<double>() - nodes[node].as<double>();
    const double size = length(along);
    known.strand = static_cast<std::uint32_t>(scene_.strands().strandOf(node));
    if (size > 0) known.tangent = (along / size).as<float>();
    return known;
}

}  // namespace kushi
