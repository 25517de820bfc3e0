// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "rod/strand_batch.h"

#include <cstdint>
#include <vector>

namespace kushi {

/// Hair comes to rest much like the hair beside it. So of some strands of a batch few go first, and
/// each of the others when two beside it are done, between which it begins.
class Guided {
public:
    /// Places in the batch.
    struct Between {
        std::uint32_t one, place, other;
    };

    Guided(const StrandBatch& batch, std::vector<std::uint32_t> places);

    /// Those that go first.
    const std::vector<std::uint32_t>& guides() const { return guides_; }

    /// Visits those that waited for a strand, and now for none.
    void release(std::uint32_t done, const auto& visit) {
        const std::uint32_t i = at_[done];
        for (std::uint32_t apart = apartOf(i) / 2; apart > 0; apart /= 2) {
            for (const std::uint32_t k : {i - apart, i + apart}) {
                if (k >= places_.size() || before_[k] == 0 || --before_[k] > 0) continue;
                visit(between(k, apart));
            }
        }
    }

private:
    // How far from the i-th the two are between which it begins.
    static std::uint32_t apartOf(std::uint32_t i);

    Between between(std::uint32_t i, std::uint32_t apart) const {
        return {places_[i - apart], places_[i], places_[i + apart]};
    }

    std::vector<std::uint32_t> places_;  // in an order in which neighbours are near
    std::vector<std::uint32_t> at_;      // of a place, its number among them
    std::vector<std::uint8_t> before_;   // of its two, those that are not done; 0 of guides
    std::vector<std::uint32_t> guides_;
};

}  // namespace kushi
