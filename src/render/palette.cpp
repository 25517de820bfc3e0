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

void Palette::mixFor(const SampleTile& samples) {
    for (const SampleTile::Key key : samples.all())
        shown_[SampleTile::id(key)] = 1;
    const std::size_t segments = items_.segments.size();
    segments_.clear();
    roundings_.clear();
    for (std::size_t i = 0; i < segments; ++i) {
        if (shown_[i + 1] != 0) segments_.push_back(items_.segments[i]);
    }
    ends_.ask(colors_, segments_);
    std::size_t next = 0;
    for (std::size_t i = 0; i < segments; ++i) {
        if (shown_[i + 1] == 0) continue;
        constexpr std::size_t ahead = 8;
        if (next + ahead < segments_.size()) scene_.prefetch(segments_[next + ahead]);
        mixSegment(segmentId(i), segments_[next], ends_[next]);
        ++next;
    }
    for (std::size_t i = 0; i < items_.triangles.size(); ++i) {
        const std::size_t id = segments + i + 1;
        if (shown_[id] != 0) paints_[id] = trianglePaint(items_.triangles[i]);
    }
}

void Palette::mixSegment(std::uint32_t id, std::uint32_t node, const EndColors::Ends& ends) {
    const std::optional<ScreenSegment> segment = scene_.segment(node);
    if (!segment) return;  // nor has it been drawn
    paints_[id] = paintOf(*segment, ends.first, ends.last, items_.x, items_.y);
    if (scene_.round() && scene_.isRibbon(*segment)) makeRound(id, *segment);
}

void Palette::makeRound(std::uint32_t id, const ScreenSegment& segment) {
    const auto& [a, b, from, to] = segment;
    const Rounding rounding =
        roundingOf({a.x - items_.x, a.y - items_.y}, {b.x - items_.x, b.y - items_.y},
                   0.5 * (a.width + b.width), supersample_);
    if (rounding.strength == 0) return;
    roundings_.resize(items_.segments.size() + items_.triangles.size() + 1);
    roundings_[id] = rounding;
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
