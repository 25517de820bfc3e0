// SPDX-License-Identifier: Apache-2.0
#include "render/analytic.h"

#include "render/resolve.h"
#include "render/ribbon.h"
#include "render/rounding.h"

#include <algorithm>
#include <array>
#include <bit>

namespace kushi {

namespace {

constexpr std::size_t together = 2048;  // segments whose colours are asked for at a time

}  // namespace

AnalyticPainter::AnalyticPainter(const Scene& scene, const TileGrid& grid, const NodeColors& colors,
                                 const DrawOptions& options, Image& image, LayeredImage* layers)
    : scene_(scene),
      colors_(colors),
      supersample_(options.supersample),
      image_(image),
      layers_(layers),
      sampler_(scene, grid),
      palette_(scene, colors, options.background, options.supersample),
      area_(grid.tileSize() / options.supersample),
      blend_(grid.tileSize() / options.supersample) {
    if (layers != nullptr) meshLayers_.emplace(scene, options.supersample, *layers);
}

void AnalyticPainter::operator()(const TileItems& items) {
    if (items.segments.empty() && items.triangles.empty()) return;
    sampler_.begin(items);
    solids_.clear();
    if (!items.triangles.empty()) {
        palette_.begin(items);
        sampler_.drawTriangles(items);
        resolve(sampler_.samples(), palette_, supersample_, image_);
        if (meshLayers_) (*meshLayers_)(sampler_.samples(), items);
        if (items.segments.empty()) return;
        solids_.take(sampler_.samples(), supersample_, scene_.projection());
    }
    horizon_.look(sampler_.samples(), scene_.projection());
    blend_.clear();
    findOrder(items);
    const std::span<const std::uint64_t> order = order_;
    for (std::size_t i = 0; i < order.size(); i += together)
        drawGroup(order.subspan(i, std::min(together, order.size() - i)));
    blendInto(items.x / supersample_, items.y / supersample_);
}

void AnalyticPainter::findOrder(const TileItems& items) {
    constexpr std::size_t ahead = 12;
    order_.clear();
    for (std::size_t i = 0; i < items.segments.size(); ++i) {
        if (i + ahead < items.segments.size()) scene_.prefetch(items.segments[i + ahead]);
        const std::uint32_t node = items.segments[i];
        const std::optional<ScreenSegment> segment = scene_.segment(node);
        if (!segment || horizon_.hides(*scene_.box(node))) continue;
        // Positive numbers have the order of their bits.
        const auto q = static_cast<float>(0.5 * (segment->a.q + segment->b.q));
        order_.push_back(std::uint64_t{~std::bit_cast<std::uint32_t>(q)} << 32U | node);
    }
    std::sort(order_.begin(), order_.end());
}

void AnalyticPainter::drawGroup(std::span<const std::uint64_t> group) {
    // Colours are asked for in the order of nodes, and used in that of depth.
    seen_.clear();
    byNode_.clear();
    for (const std::uint64_t thing : group) {
        const auto node = static_cast<std::uint32_t>(thing);
        if (!mayBeSeen(*scene_.segment(node))) continue;
        byNode_.push_back(std::uint64_t{node} << 32U | seen_.size());
        seen_.push_back({node, 0});
    }
    std::sort(byNode_.begin(), byNode_.end());
    nodes_.clear();
    for (const std::uint64_t entry : byNode_) {
        seen_[static_cast<std::uint32_t>(entry)].place = nodes_.size();
        nodes_.push_back(static_cast<std::uint32_t>(entry >> 32U));
    }
    ends_.ask(colors_, nodes_);
    for (const auto& [node, place] : seen_)
        drawSegment(node, *scene_.segment(node), ends_[place]);
}

PixelPoint AnalyticPainter::onPixels(const ScreenPoint& point) const {
    const SampleTile& samples = sampler_.samples();
    const double perSample = 1.0 / supersample_;
    return {(point.x - samples.x()) * perSample, (point.y - samples.y()) * perSample};
}

bool AnalyticPainter::mayBeSeen(const ScreenSegment& segment) const {
    const PixelPoint a = onPixels(segment.a);
    const PixelPoint b = onPixels(segment.b);
    const double margin = segment.margin() / supersample_;
    return blend_.anyOpen(std::min(a.x, b.x) - margin, std::min(a.y, b.y) - margin,
                          std::max(a.x, b.x) + margin, std::max(a.y, b.y) + margin);
}

void AnalyticPainter::drawSegment(std::uint32_t node, const ScreenSegment& segment,
                                  const EndColors::Ends& ends) {
    if (!mayBeSeen(segment)) return;
    const ScreenPolygon ribbon = ribbonOf(scene_, node, segment);
    if (ribbon.size != 4) return;
    std::array<PixelPoint, 4> corners;
    for (std::size_t i = 0; i < 4; ++i)
        corners[i] = onPixels(ribbon.corners[i].at);

    const PixelPoint a = onPixels(segment.a);
    const PixelPoint b = onPixels(segment.b);
    // Colour by distance and 1 / distance at both ends; how far along each pixel's centre lies.
    const auto paintAt = [&](const ScreenPoint& at, double share) {
        return scaled(mixed(ends.first, ends.last, share), at.q);
    };
    const Float4 atA = paintAt(segment.a, segment.from);
    const Float4 change = paintAt(segment.b, segment.to) - atA;
    const double x = b.x - a.x;
    const double y = b.y - a.y;
    const double inverse = 1 / std::max(x * x + y * y, 1e-12);
    const auto perX = static_cast<float>(x * inverse);
    const auto perY = static_cast<float>(y * inverse);
    const auto start = static_cast<float>(((0.5 - a.x) * x + (0.5 - a.y) * y) * inverse);
    const double width = 0.5 * (segment.a.width + segment.b.width) / supersample_;
    const Rounding rounding = scene_.round() ? roundingOf(a, b, width, 1) : Rounding();
    area_.cover(corners, [&](int column, int row, float area) {
        if (!blend_.isOpen(column, row)) return;
        const float along =
            start + static_cast<float>(column) * perX + static_cast<float>(row) * perY;
        const Float4 value = atA + std::clamp(along, 0.0F, 1.0F) * change;
        const float seen = solids_.seen(column, row, value[3]);
        if (seen <= 0) return;
        const float round = rounding.at(static_cast<float>(column), static_cast<float>(row));
        blend_.add(column, row, node, area * seen, value * (round / value[3]));
    });
}

void AnalyticPainter::blendInto(int left, int top) {
    const int size = sampler_.samples().size() / supersample_;
    const int columns = std::min(size, image_.width - left);
    const int rows = std::min(size, image_.height - top);
    for (int y = 0; y < rows; ++y) {
        for (int x = 0; x < columns; ++x) {
            const float behind = blend_.left(x, y);
            if (behind == 1) continue;
            const Float4 light = blend_.light(x, y);
            Rgb& pixel = image_.at(left + x, top + y);
            pixel = Rgb{light[0], light[1], light[2]} + pixel * behind;
            if (layers_ == nullptr) continue;
            const std::size_t place =
                static_cast<std::size_t>(top + y) * static_cast<std::size_t>(image_.width) +
                static_cast<std::size_t>(left + x);
            float& alpha = layers_->alpha[place];
            alpha = 1 - behind * (1 - alpha);
            if (!layers_->mask.empty()) layers_->mask[place] = 1 - behind;
        }
    }
}

}  // namespace kushi
