// SPDX-License-Identifier: Apache-2.0
#include "io/chains.h"

#include "io/text.h"

#include <limits>

namespace kushi {
namespace {

constexpr std::uint32_t none = std::numeric_limits<std::uint32_t>::max();

template <class T>
std::vector<T> pick(const std::vector<T>& values, const std::vector<std::uint32_t>& order) {
    std::vector<T> picked;
    if (values.empty()) return picked;
    picked.reserve(order.size());
    for (const std::uint32_t vertex : order)
        picked.push_back(values[vertex]);
    return picked;
}

}  // namespace

Result<Chains> followEdges(std::uint32_t vertexCount, std::span<const Edge> edges,
                           const std::string& file) {
    std::vector<std::uint32_t> next(vertexCount, none);
    std::vector<bool> entered(vertexCount, false);
    for (const auto& [from, to] : edges) {
        if (next[from] != none || entered[to]) {
            const bool leaving = next[from] != none;
            return badFile(file, "two edges " + std::string(leaving ? "leave" : "enter") +
                                     " vertex " + std::to_string(leaving ? from : to) +
                                     " (counted from 0); a strand's edges run from root to tip "
                                     "without branching");
        }
        next[from] = to;
        entered[to] = true;
    }

    Chains chains;
    chains.order.reserve(vertexCount);
    for (std::uint32_t root = 0; root < vertexCount; ++root) {
        if (entered[root]) continue;
        for (std::uint32_t vertex = root; vertex != none; vertex = next[vertex]) {
            chains.order.push_back(vertex);
        }
        chains.offsets.push_back(static_cast<std::uint32_t>(chains.order.size()));
    }
    if (chains.order.size() < vertexCount) {
        return badFile(file, "the edges form a closed loop; a strand has a root and a tip");
    }
    return chains;
}

Strands gather(const Strands& vertices, const Chains& chains) {
    Strands strands;
    strands.nodes = pick(vertices.nodes, chains.order);
    strands.diameters = pick(vertices.diameters, chains.order);
    strands.transparency = pick(vertices.transparency, chains.order);
    strands.colors = pick(vertices.colors, chains.order);
    strands.offsets = chains.offsets;
    return strands;
}

}  // namespace kushi
