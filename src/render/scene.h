// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "core/float4.h"
#include "render/projection.h"

#include <kushi/draw.h>
#include <kushi/mesh.h>
#include <kushi/strands.h>

#include <algorithm>
#include <array>
#include <bit>
#include <cstddef>
#include <cstdint>
#include <optional>
#include <vector>

namespace kushi {

/// A segment on the picture. Where it crosses the near plane only a part of it is left.
struct ScreenSegment {
    ScreenPoint a, b;
    double from = 0, to = 1;  ///< where a and b lie along the segment in space

    /// 1 / distance of its nearest point [1/m].
    float nearest() const { return static_cast<float>(std::max(a.q, b.q)); }
    /// At its wider end [samples].
    double widest() const { return std::max(a.width, b.width); }
    double margin() const { return marginOf(widest()); }

    /// How far from the line between a and b there may be samples of it, along either axis: the
    /// corners of ribbons lie up to sqrt(1/2) widths away, and lines round by a half. With a little
    /// to spare for floats.
    template <class Number>
    static Number marginOf(Number widest) {
        return Number(0.52) + Number(0.71) * widest;
    }
};

/// What bounds a segment on the picture.
struct SegmentBox {
    Float4 sides;   ///< left, top, right and bottom of all its samples [samples]
    float nearest;  ///< 1 / distance of its nearest point [1/m]
};

/// Of the points a segment lies between, each x, y, q and width as StoredPoint has them.
inline SegmentBox boxBetween(Float4 a, Float4 b) {
    const Float4 low = smaller(a, b);
    const Float4 high = larger(a, b);
    const float margin = ScreenSegment::marginOf(high[3]);
    const Float4 sides = {low[0] - margin, low[1] - margin, high[0] + margin, high[1] + margin};
    return {sides, high[2]};
}
SegmentBox boxOf(const ScreenSegment& segment);

/// A convex polygon on the picture: what the near plane leaves of a triangle.
struct ScreenPolygon {
    struct Corner {
        ScreenPoint at;
        std::array<double, 3> weights;  ///< of the triangle's corners
    };
    std::array<Corner, 4> corners;
    int size = 0;  ///< 0, 3 or 4

    /// 1 / distance of its nearest point [1/m]; 0 without points.
    float nearest() const {
        double q = 0;
        for (int i = 0; i < size; ++i)
            q = std::max(q, corners[static_cast<std::size_t>(i)].at.q);
        return static_cast<float>(q);
    }
};

/// Strands and mesh as a camera sees them. Refers to both.
class Scene {
public:
    /// options  for how wide strands are, and the threads to work with
    Scene(const Strands& strands, const Mesh& mesh, const Projection& projection,
          const DrawOptions& options);

    const Strands& strands() const { return strands_; }
    const Mesh& mesh() const { return mesh_; }
    const Projection& projection() const { return projection_; }

    /// The segment that begins at a node, if any of it can be drawn.
    std::optional<ScreenSegment> segment(std::uint32_t firstNode) const {
        const StoredPoint a = nodes_[firstNode];
        const StoredPoint b = nodes_[firstNode + 1];
        if (a.inFront() && b.inFront()) return ScreenSegment{a, b};
        return clippedSegment(firstNode);
    }
    /// Its box, if any of it can be drawn.
    std::optional<SegmentBox> box(std::uint32_t firstNode) const {
        const auto a = std::bit_cast<Float4>(nodes_[firstNode]);
        const auto b = std::bit_cast<Float4>(nodes_[firstNode + 1]);
        if (a[2] > 0 && b[2] > 0) return boxBetween(a, b);
        const std::optional<ScreenSegment> segment = clippedSegment(firstNode);
        return segment ? std::optional(boxOf(*segment)) : std::nullopt;
    }
    ScreenPolygon triangle(std::uint32_t index) const;
    /// Whether a segment is drawn as a ribbon and not as a line.
    bool isRibbon(const ScreenSegment& segment) const { return segment.widest() > widestLine_; }
    /// Whether wide strands are to look round.
    bool round() const { return round_; }
    bool beginsStrand(std::uint32_t node) const { return begins_[node] != 0; }
    bool endsStrand(std::uint32_t node) const { return begins_[std::size_t{node} + 1] != 0; }
    /// Asks the memory for a segment that will be wanted soon.
    void prefetch(std::uint32_t firstNode) const {
        __builtin_prefetch(&nodes_[firstNode]);
        __builtin_prefetch(&nodes_[firstNode + 1]);
    }

private:
    std::optional<ScreenSegment> clippedSegment(std::uint32_t firstNode) const;
    ScreenPolygon clippedTriangle(std::uint32_t index) const;
    double diameter(std::size_t node) const;  // m
    /// In samples, where 1 / distance is q.
    double widthOf(double diameter, double q) const;

    const Strands& strands_;
    const Mesh& mesh_;
    Projection projection_;
    std::vector<StoredPoint> nodes_, vertices_;
    std::vector<std::uint8_t> begins_;  // by node, and one more
    double widestLine_;                 // samples
    bool round_;
    double widthScale_;  // samples of a metre at a metre; 0: all strands are one sample wide
};

}  // namespace kushi
