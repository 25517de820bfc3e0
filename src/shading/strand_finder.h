// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "shading/tangents.h"

#include <kushi/strands.h>

#include <cstddef>
#include <cstdint>

namespace kushi {

/// The strand of one node after the other: most often that of the node before.
class StrandFinder {
public:
    explicit StrandFinder(const Strands& strands) : strands_(strands) {}

    /// Turns to a node's strand; whether that is another one.
    bool turnTo(std::uint32_t node) {
        if (node >= first_ && node < end_) return false;
        strand_ = strands_.strandOf(node);
        first_ = strands_.offsets[strand_];
        end_ = strands_.offsets[strand_ + 1];
        return true;
    }

    std::size_t strand() const { return strand_; }
    /// The strand's direction at one of its nodes.
    Vec3f tangent(std::uint32_t node) const {
        return tangentAt(strands_.strand(strand_), node - first_);
    }

private:
    const Strands& strands_;
    std::size_t strand_ = 0;
    std::uint32_t first_ = 0, end_ = 0;  // its nodes
};

}  // namespace kushi
