// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <utility>
#include <vector>

namespace kushi {

using Triangle = std::array<std::uint32_t, 3>;

/// The edges of a surface, each once, by ascending ends.
class Edges {
public:
    using Ends = std::pair<std::uint32_t, std::uint32_t>;

    explicit Edges(const std::vector<Triangle>& triangles);

    std::size_t size() const { return ends_.size(); }
    Ends ends(std::size_t edge) const { return ends_[edge]; }
    bool contains(std::uint32_t a, std::uint32_t b) const;
    /// The three edges of a triangle; the first runs from its first corner to its second.
    const Triangle& ofTriangle(std::size_t triangle) const { return ofTriangle_[triangle]; }

private:
    std::vector<Ends> ends_;
    std::vector<Triangle> ofTriangle_;
};

}  // namespace kushi
