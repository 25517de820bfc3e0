// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <kushi/node_colors.h>

#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

namespace kushi {

/// The colours of both nodes of some segments, asked for together.
class EndColors {
public:
    struct Ends {
        Rgb first, last;
    };

    /// segments  by their first node, ascending
    void ask(const NodeColors& colors, std::span<const std::uint32_t> segments) {
        nodes_.clear();
        firsts_.clear();
        for (const std::uint32_t node : segments) {
            // Segments in a row share a node.
            if (nodes_.empty() || nodes_.back() != node) nodes_.push_back(node);
            firsts_.push_back(nodes_.size() - 1);
            nodes_.push_back(node + 1);
        }
        colors_.resize(nodes_.size());
        if (!nodes_.empty()) colors(nodes_, colors_);
    }

    /// Of the i-th of the segments asked for last.
    Ends operator[](std::size_t i) const { return {colors_[firsts_[i]], colors_[firsts_[i] + 1]}; }

private:
    std::vector<std::uint32_t> nodes_;
    std::vector<std::size_t> firsts_;  // in nodes_
    std::vector<Rgb> colors_;
};

}  // namespace kushi
