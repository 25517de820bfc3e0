// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <kushi/result.h>
#include <kushi/strands.h>

#include <string>
#include <string_view>

namespace kushi {

// Strands in PLY, as in the files of CT2Hair and hairutil: element `vertex` with x y z, element
// `strand` with `nsegs` (nodes - 1); for mesh viewers also element `edge` with vertex1 vertex2.

/// The groom in the bytes of a .ply file; `file` stands in the problems.
///
/// Where there is no `strand`, edges running from root to tip make the strands. Colours in uchar or
/// ushort become 0 to 1. Other elements and properties are passed over, but not faces.
Result<Strands> parsePly(std::string_view bytes, const std::string& file);

/// The bytes of a binary little-endian .ply file with all attributes but keys.
Result<std::string> formatPly(const Strands& strands, const std::string& file);

}  // namespace kushi
