// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "core/random.h"

#include <kushi/strands.h>

#include <cstddef>

namespace kushi {

/// In [-1, 1), by the strand's key: the share of a look's tiltVariation by which its scales are
/// tilted more than others'.
inline float strandTilt(const Strands& strands, std::size_t strand) {
    constexpr std::uint64_t salt = 0x74696c74;
    const std::uint64_t key = strands.keys.empty() ? strand : strands.keys[strand];
    return static_cast<float>(uniformSigned(mixKey(key, salt)));
}

}  // namespace kushi
