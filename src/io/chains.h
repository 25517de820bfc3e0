// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <kushi/result.h>
#include <kushi/strands.h>

#include <array>
#include <cstdint>
#include <span>
#include <string>
#include <vector>

namespace kushi {

/// From the earlier vertex, nearer the root, to the later.
using Edge = std::array<std::uint32_t, 2>;

/// Strands as lists of vertices: strand i is order[offsets[i]] .. order[offsets[i + 1] - 1].
struct Chains {
    std::vector<std::uint32_t> order;
    std::vector<std::uint32_t> offsets = {0};
};

/// Follows edges from root to tip. The strands come in the order of their roots' indices; a vertex
/// without edges is a strand of one node.
///
/// edges  of vertices < vertexCount
/// A vertex with two edges coming in or going out, or a closed loop, is a problem.
Result<Chains> followEdges(std::uint32_t vertexCount, std::span<const Edge> edges,
                           const std::string& file);

/// The vertices in the order of the chains, with their attributes; `vertices` needs no offsets.
Strands gather(const Strands& vertices, const Chains& chains);

}  // namespace kushi
