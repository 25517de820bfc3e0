// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <kushi/settle.h>

namespace kushi {

/// What is wrong with a groom, at the place where the style names its file.
Problem atSource(const Problem& problem, const GroomSource& source);

/// Some strands of a groom, by their places in it, with what they have.
Strands subset(const Strands& groom, std::span<const std::uint32_t> which);

/// Gives every strand what its file does not say: a key (of `seed` and its place in the file), the
/// diameters of the part's hair, and its colours.
void complete(Strands& groom, const Part& part, std::uint64_t seed);

}  // namespace kushi
