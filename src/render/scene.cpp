// SPDX-License-Identifier: Apache-2.0
#include "render/scene.h"

#include "core/parallel.h"
#include "render/line.h"

#include <algorithm>
#include <cstddef>
#include <span>

namespace kushi {

namespace {

constexpr double mostWidth = 65536;  // samples, so that no corner lies too far out

std::vector<StoredPoint> project(const Projection& projection, std::span<const Vec3f> points,
                                 int threads) {
    std::vector<StoredPoint> stored(points.size());
    parallelFor(points.size(), 16384, threads, [&](std::size_t begin, std::size_t end) {
        for (std::size_t i = begin; i < end; ++i)
            stored[i] = projection.store(points[i]);
    });
    return stored;
}

/// Share of the way from `front` to `behind` at which the near plane is crossed. Who shares the
/// edge computes the same, as the order is that of the picture's depth and not of the corners.
double crossing(Vec3d front, Vec3d behind, double near) {
    return (front.z - near) / (front.z - behind.z);
}

}  // namespace

SegmentBox boxOf(const ScreenSegment& segment) {
    const auto numbers = [](const ScreenPoint& p) {
        return Float4{static_cast<float>(p.x), static_cast<float>(p.y), static_cast<float>(p.q),
                      static_cast<float>(p.width)};
    };
    return boxBetween(numbers(segment.a), numbers(segment.b));
}

Scene::Scene(const Strands& strands, const Mesh& mesh, const Projection& projection,
             const DrawOptions& options)
    : strands_(strands),
      mesh_(mesh),
      projection_(projection),
      nodes_(project(projection, strands.nodes, options.threads)),
      vertices_(project(projection, mesh.vertices, options.threads)),
      widestLine_(options.stroke == Stroke::Analytic ? -1 : Line::widest),
      round_(options.round),
      widthScale_(options.stroke == Stroke::Line ? 0 : options.widen * projection.focalLength()) {
    begins_.assign(nodes_.size() + 1, 0);
    for (const std::uint32_t first : strands.offsets)
        begins_[first] = 1;
    if (widthScale_ == 0) return;
    parallelFor(nodes_.size(), 65536, options.threads, [&](std::size_t begin, std::size_t end) {
        for (std::size_t i = begin; i < end; ++i)
            nodes_[i].width = static_cast<float>(widthOf(diameter(i), nodes_[i].q));
    });
}

double Scene::diameter(std::size_t node) const {
    return strands_.diameters.size() == nodes_.size() ? strands_.diameters[node] : usualDiameter;
}

double Scene::widthOf(double diameter, double q) const {
    const double width = widthScale_ * diameter * q;
    return width > 0 ? std::min(width, mostWidth) : 0;  // not a number is no width
}

std::optional<ScreenSegment> Scene::clippedSegment(std::uint32_t firstNode) const {
    const StoredPoint a = nodes_[firstNode];
    const StoredPoint b = nodes_[firstNode + 1];
    if (!a.drawable() || !b.drawable() || a.inFront() == b.inFront()) return std::nullopt;

    const Vec3d viewA = projection_.toView(strands_.nodes[firstNode]);
    const Vec3d viewB = projection_.toView(strands_.nodes[firstNode + 1]);
    const Vec3d front = a.inFront() ? viewA : viewB;
    const Vec3d behind = a.inFront() ? viewB : viewA;
    const double share = crossing(front, behind, projection_.nearPlane());
    Vec3d cut = front + share * (behind - front);
    cut.z = projection_.nearPlane();
    ScreenPoint point = projection_.toScreen(cut);
    if (!canBeDrawn(point)) return std::nullopt;
    const double fromA = a.inFront() ? share : 1 - share;
    if (widthScale_ > 0) {
        const double there =
            (1 - fromA) * diameter(firstNode) + fromA * diameter(std::size_t{firstNode} + 1);
        point.width = widthOf(there, point.q);
    }
    if (a.inFront()) return ScreenSegment{.a = a, .b = point, .from = 0, .to = share};
    return ScreenSegment{.a = point, .b = b, .from = 1 - share, .to = 1};
}

ScreenPolygon Scene::triangle(std::uint32_t index) const {
    const auto& [i, j, k] = mesh_.triangles[index];
    const StoredPoint a = vertices_[i];
    const StoredPoint b = vertices_[j];
    const StoredPoint c = vertices_[k];
    if (!a.drawable() || !b.drawable() || !c.drawable()) return {};
    if (!a.inFront() || !b.inFront() || !c.inFront()) return clippedTriangle(index);
    return {{{{a, {1, 0, 0}}, {b, {0, 1, 0}}, {c, {0, 0, 1}}}}, 3};
}

ScreenPolygon Scene::clippedTriangle(std::uint32_t index) const {
    const auto& corners = mesh_.triangles[index];
    const double near = projection_.nearPlane();
    ScreenPolygon polygon;
    const auto add = [&](ScreenPoint at, std::array<double, 3> weights) {
        polygon.corners[static_cast<std::size_t>(polygon.size++)] = {at, weights};
    };

    // Walk round the triangle; keep the corners in front and the crossings.
    for (std::size_t from = 0; from < 3; ++from) {
        const std::size_t to = (from + 1) % 3;
        const StoredPoint start = vertices_[corners[from]];
        const StoredPoint stop = vertices_[corners[to]];
        if (start.inFront()) {
            std::array<double, 3> weights{};
            weights[from] = 1;
            add(start, weights);
        }
        if (start.inFront() == stop.inFront()) continue;
        const std::size_t front = start.inFront() ? from : to;
        const std::size_t behind = start.inFront() ? to : from;
        const Vec3d viewFront = projection_.toView(mesh_.vertices[corners[front]]);
        const Vec3d viewBehind = projection_.toView(mesh_.vertices[corners[behind]]);
        const double share = crossing(viewFront, viewBehind, near);
        Vec3d cut = viewFront + share * (viewBehind - viewFront);
        cut.z = near;
        const ScreenPoint point = projection_.toScreen(cut);
        if (!canBeDrawn(point)) return {};
        std::array<double, 3> weights{};
        weights[front] = 1 - share;
        weights[behind] = share;
        add(point, weights);
    }
    return polygon;
}

}  // namespace kushi
