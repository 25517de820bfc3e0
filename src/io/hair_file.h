// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <kushi/result.h>
#include <kushi/strands.h>

#include <string>
#include <string_view>

namespace kushi {

// Cem Yuksel's .hair: a header of 128 bytes, then those of the arrays segments, points, thickness,
// transparency and colours that the header announces (cemyuksel.com/research/hairmodels).

/// The groom in the bytes of a .hair file; `file` stands in the problems.
///
/// The header's default thickness, transparency and colour are not read: most writers leave
/// placeholders there, such as hair 1 cm thick. Bytes after the last array are a problem.
Result<Strands> parseHair(std::string_view bytes, const std::string& file);

/// The bytes of a .hair file. Strands of one node, which the format's readers lose, and of more
/// than 65,536, whose segments a 16-bit count cannot hold, are a problem.
Result<std::string> formatHair(const Strands& strands, const std::string& file);

}  // namespace kushi
