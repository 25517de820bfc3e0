// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "core/parallel.h"

#include <kushi/node_colors.h>

#include <numeric>
#include <vector>

namespace kushi {

/// Those of all nodes.
inline void colorAll(const NodeColors& colorsOf, std::span<Rgb> colors, int threads) {
    parallelFor(colors.size(), 8192, threads, [&](std::size_t begin, std::size_t end) {
        std::vector<std::uint32_t> nodes(end - begin);
        std::iota(nodes.begin(), nodes.end(), static_cast<std::uint32_t>(begin));
        colorsOf(nodes, colors.subspan(begin, end - begin));
    });
}

}  // namespace kushi
