// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <kushi/color.h>
#include <kushi/vec.h>

#include <cstddef>
#include <cstdint>
#include <limits>
#include <optional>
#include <span>
#include <string>
#include <vector>

namespace kushi {

/// Diameter of strands that do not say [m].
inline constexpr float usualDiameter = 75e-6F;

/// A groom: polylines, each from root to tip, one after the other.
///
/// Strand i owns the nodes [offsets[i], offsets[i + 1]). Attributes are either empty or complete.
/// A strand of a single node (a bald follicle in some data sets) is allowed and has length 0.
struct Strands {
    std::vector<Vec3f> nodes;                  ///< m; a strand's first node is its follicle
    std::vector<std::uint32_t> offsets = {0};  ///< size() + 1 of them

    std::vector<std::uint64_t> keys;  ///< per strand: the follicle's identity, or empty

    std::vector<float> diameters;     ///< per node, m, or empty
    std::vector<float> transparency;  ///< per node, 0 opaque to 1, or empty
    std::vector<Rgb> colors;          ///< per node, as the file has them, or empty

    std::size_t size() const { return offsets.size() - 1; }
    std::size_t segmentCount() const { return nodes.size() - size(); }
    std::span<const Vec3f> strand(std::size_t i) const {
        return std::span(nodes).subspan(offsets[i], offsets[i + 1] - offsets[i]);
    }
    std::span<Vec3f> strand(std::size_t i) {
        return std::span(nodes).subspan(offsets[i], offsets[i + 1] - offsets[i]);
    }
    /// The strand that has a node; one of them must.
    std::size_t strandOf(std::uint32_t node) const;
    /// Adds a strand without attributes.
    void add(std::span<const Vec3f> strandNodes, std::uint64_t key);
};

/// Length of a polyline [m].
double polylineLength(std::span<const Vec3f> nodes);

/// An axis-aligned box [m]; empty while low > high.
struct Bounds {
    Vec3f low = {std::numeric_limits<float>::max(), std::numeric_limits<float>::max(),
                 std::numeric_limits<float>::max()};
    Vec3f high = {std::numeric_limits<float>::lowest(), std::numeric_limits<float>::lowest(),
                  std::numeric_limits<float>::lowest()};

    bool empty() const { return low.x > high.x; }
    void include(Vec3f point);
    Vec3f center() const { return (low + high) * 0.5F; }
    /// Half the diagonal [m]; 0 if empty.
    float radius() const { return empty() ? 0 : 0.5F * length(high - low); }
};

Bounds boundsOf(std::span<const Vec3f> points);

/// What `kushi info` says about a groom.
struct GroomSummary {
    std::size_t strands = 0, nodes = 0, segments = 0;
    double minLength = 0, meanLength = 0, maxLength = 0;  ///< m
    Bounds bounds;
    std::vector<std::string> attributes;  ///< names of the attributes present
};

GroomSummary summarize(const Strands& strands);

}  // namespace kushi
