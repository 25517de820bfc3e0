// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <kushi/strands.h>

#include <algorithm>

namespace kushi::test {

/// How far a node is from the same node of another groom, at most.
inline float farthest(const Strands& a, const Strands& b) {
    float most = 0;
    for (std::size_t j = 0; j < a.nodes.size(); ++j)
        most = std::max(most, length(a.nodes[j] - b.nodes[j]));
    return most;
}

}  // namespace kushi::test
