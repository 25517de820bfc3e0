// SPDX-License-Identifier: Apache-2.0
#include "render/near_first.h"

#include <algorithm>
#include <array>
#include <functional>

namespace kushi {

void NearFirst::sort() {
    // Where to part them is guessed from a few.
    constexpr std::size_t samples = 32;
    std::array<float, samples> some{};
    for (std::size_t i = 0; i < samples && !things_.empty(); ++i)
        some[i] = things_[i * things_.size() / samples].q;
    std::sort(some.begin(), some.end(), std::greater<>());
    const auto groupOf = [&](float q) {
        std::size_t group = 0;
        for (std::size_t i = 1; i < groups; ++i)
            group += static_cast<std::size_t>(q < some[i * samples / groups]);
        return group;
    };

    std::array<std::size_t, groups> next{};
    for (const Thing& thing : things_)
        ++next[groupOf(thing.q)];
    starts_[0] = 0;
    for (std::size_t i = 0; i < groups; ++i) {
        starts_[i + 1] = starts_[i] + next[i];
        next[i] = starts_[i];
    }
    sorted_.resize(things_.size());
    for (const Thing& thing : things_)
        sorted_[next[groupOf(thing.q)]++] = thing.index;
}

}  // namespace kushi
