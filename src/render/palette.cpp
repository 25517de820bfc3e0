// SPDX-License-Identifier: Apache-2.0
#include "render/palette.h"

#include <algorithm>
#include <array>

namespace kushi {

void Palette::begin(const TileItems& items) {
    items_ = items;
    const std::size_t ids = items.segments.size() + items.triangles.size() + 1;
    paints_.resize(std::max(paints_.size(), ids));
    shown_.assign(ids, 0);
    paints_[0] = background_;
}

void Palette::mixFor(const SampleTile& samples, int supersample) {
    supersample_ = supersample;
    roundings_.clear();
    for (const SampleTile::Key key : samples.all())
        shown_[SampleTile::id(key)] = 1;
    const std::size_t segments = items_.segments.size();
    for (std::size_t i = 0; i < segments; ++i) {
        constexpr std::size_t ahead = 16;
        if (i + ahead < segments && shown_[i + ahead + 1] != 0) {
            scene_.prefetch(items_.segments[i + ahead]);
            __builtin_prefetch(&colors_[items_.segments[i + ahead]]);
        }
        if (shown_[i + 1] != 0) paints_[i + 1] = segmentPaint(i);
    }
    for (std::size_t i = 0; i < items_.triangles.size(); ++i) {
        const std::size_t id = segments + i + 1;
        if (shown_[id] != 0) paints_[id] = trianglePaint(items_.triangles[i]);
    }
}

void Palette::makeRound(std::size_t index, const ScreenSegment& segment) {
    const auto& [a, b, from, to] = segment;
    const PixelPoint first = {a.x - items_.x, a.y - items_.y};
    const PixelPoint last = {b.x - items_.x, b.y - items_.y};
    const Rounding rounding = roundingOf(first, last, 0.5 * (a.width + b.width), supersample_);
    if (rounding.strength == 0) return;
    roundings_.resize(items_.segments.size() + items_.triangles.size() + 1);
    roundings_[segmentId(index)] = rounding;
}

Paint Palette::segmentPaint(std::size_t index) {
    const std::uint32_t node = items_.segments[index];
    const std::optional<ScreenSegment> segment = scene_.segment(node);
    if (!segment) return {};  // nor has it been drawn
    if (scene_.round() && scene_.isRibbon(*segment)) makeRound(index, *segment);
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
