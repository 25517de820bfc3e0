// SPDX-License-Identifier: Apache-2.0
#include "render/palette.h"

#include <algorithm>
#include <array>

namespace kushi {

void Palette::begin(const TileItems& items) {
    items_ = items;
    const std::size_t ids = items.segments.size() + items.triangles.size() + 1;
    paints_.resize(std::max(paints_.size(), ids));
    mixed_.assign(ids, 0);
    paints_[0] = background_;
    mixed_[0] = 1;
}

void Palette::mix(std::uint32_t id) {
    const std::size_t index = id - 1;
    const std::size_t segments = items_.segments.size();
    paints_[id] = index < segments ? segmentPaint(items_.segments[index])
                                   : trianglePaint(items_.triangles[index - segments]);
    mixed_[id] = 1;
}

Paint Palette::segmentPaint(std::uint32_t node) const {
    const std::optional<ScreenSegment> segment = scene_.segment(node);
    if (!segment) return {};  // nor has it been drawn
    return paintOf(*segment, colors_[node], colors_[node + 1], items_.x, items_.y);
}

Paint Palette::trianglePaint(std::uint32_t index) const {
    const Mesh& mesh = scene_.mesh();
    std::array<Rgb, 3> colors;
    for (std::size_t i = 0; i < 3; ++i) {
        constexpr Rgb grey = {0.5F, 0.5F, 0.5F};
        colors[i] = mesh.colors.empty() ? grey : mesh.colors[mesh.triangles[index][i]];
    }
    return paintOf(scene_.triangle(index), colors, items_.x, items_.y);
}

}  // namespace kushi
