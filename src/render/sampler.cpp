// SPDX-License-Identifier: Apache-2.0
#include "render/sampler.h"

#include "render/palette.h"
#include "render/stroke.h"
#include "render/triangle.h"

namespace kushi {

void Sampler::drawTriangles(const TileItems& items) {
    order_.clear();
    for (std::size_t i = 0; i < items.triangles.size(); ++i) {
        const ScreenPolygon polygon = scene_.triangle(items.triangles[i]);
        if (polygon.size > 0) order_.add(static_cast<std::uint32_t>(i), polygon.nearest());
    }
    const auto ask = [](std::uint32_t) {};
    nearFirst(ask, [&](std::uint32_t i, bool mayBeHidden) {
        const ScreenPolygon polygon = scene_.triangle(items.triangles[i]);
        if (mayBeHidden && horizon_.hides(polygon)) return;
        drawPolygon(samples_, polygon, scene_.projection(), Palette::triangleId(items, i));
    });
}

void Sampler::drawSegments(const TileItems& items) {
    horizon_.look(samples_, scene_.projection());
    // Strands come in any order, so every segment is far from the last one in memory.
    constexpr std::size_t ahead = 24;
    order_.clear();
    for (std::size_t i = 0; i < items.segments.size(); ++i) {
        if (i + ahead < items.segments.size()) scene_.prefetch(items.segments[i + ahead]);
        const std::optional<SegmentBox> box = scene_.box(items.segments[i]);
        if (!box || horizon_.hides(*box)) continue;
        order_.add(static_cast<std::uint32_t>(i), box->nearest);
    }
    const auto ask = [&](std::uint32_t i) { scene_.prefetch(items.segments[i]); };
    nearFirst(ask, [&](std::uint32_t i, bool mayBeHidden) {
        const std::uint32_t node = items.segments[i];
        if (mayBeHidden && horizon_.hides(*scene_.box(node))) return;
        drawSegment(samples_, scene_, node, *scene_.segment(node), grid_, Palette::segmentId(i));
    });
}

/// Draws what is in order_, and takes another look at the horizon between its groups if there is so
/// much that this may save more than it costs.
///
/// ask  the memory for a thing that will be drawn soon
template <class Ask, class DrawThing>
void Sampler::nearFirst(const Ask& ask, const DrawThing& drawThing) {
    order_.sort();
    const bool looks = order_.size() > 100;
    for (std::size_t i = 0; i < NearFirst::groups; ++i) {
        const bool mayBeHidden = i > 0 && looks;
        if (mayBeHidden) horizon_.look(samples_, scene_.projection());
        constexpr std::size_t ahead = 16;
        const std::span<const std::uint32_t> group = order_.group(i);
        for (std::size_t j = 0; j < group.size(); ++j) {
            if (j + ahead < group.size()) ask(group[j + ahead]);
            drawThing(group[j], mayBeHidden);
        }
    }
}

}  // namespace kushi
