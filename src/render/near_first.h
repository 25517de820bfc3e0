// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

namespace kushi {

/// Things in groups from near to far, each about as large as the others. Within a group they keep
/// their order. Once the near are drawn, most of the far may prove hidden.
class NearFirst {
public:
    static constexpr std::size_t groups = 4;

    void clear() { things_.clear(); }
    /// q  1 / distance of its nearest point, or anything that grows with it
    void add(std::uint32_t index, float q) { things_.push_back({index, q}); }
    void sort();

    std::size_t size() const { return things_.size(); }
    /// The indices added; after sort().
    std::span<const std::uint32_t> group(std::size_t i) const {
        return std::span(sorted_).subspan(starts_[i], starts_[i + 1] - starts_[i]);
    }

private:
    struct Thing {
        std::uint32_t index;
        float q;
    };
    std::vector<Thing> things_;
    std::vector<std::uint32_t> sorted_;
    std::size_t starts_[groups + 1] = {};
};

}  // namespace kushi
