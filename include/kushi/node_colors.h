// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <kushi/color.h>

#include <cstdint>
#include <functional>
#include <span>

namespace kushi {

/// Linear colours of nodes, made as they are asked for: of a head of hair a picture shows a third.
/// Several threads may call it at once; a node has the same colour each time.
///
/// nodes   places in Strands::nodes, ascending
/// colors  one for each of them; overwritten
using NodeColors = std::function<void(std::span<const std::uint32_t> nodes, std::span<Rgb> colors)>;

}  // namespace kushi
