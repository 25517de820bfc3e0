// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>

#include <kushi/result.h>
#include <kushi/strands.h>

namespace kushi {

/// Whether the extension of `path` is one that readGroom and writeGroom know: .hair, .ply, .obj.
bool isGroomPath(const std::string& path);

/// Reads a groom; the format follows from the extension. Files are in centimetres, y up.
///
/// A file that is truncated, contradicts itself or holds a coordinate that is not finite is a
/// problem that says where and what was expected; nothing is guessed.
Result<Strands> readGroom(const std::string& path);

/// Writes a groom; the format follows from the extension. The file appears whole or not at all.
///
/// .hair cannot hold a strand of one node or of more than 65,536, nor .obj attributes; see
/// docs/formats.md for what each format keeps.
Status writeGroom(const Strands& strands, const std::string& path);

}  // namespace kushi
