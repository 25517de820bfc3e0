// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <kushi/result.h>
#include <kushi/strands.h>

#include <string>
#include <string_view>

namespace kushi {

// Strands in Wavefront OBJ: `v` and polylines `l`.

/// The groom in the text of an .obj file; `file` stands in the problems.
///
/// Every `l` is a strand, but lines of two vertices that follow each other and chain (l 1 2, l 2 3)
/// make one together; every vertex of a `p` is a strand of one node. Indices may be negative and
/// carry a texture index. Names, groups, materials, normals, texture coordinates and what follows x
/// y z in a `v` are passed over. Faces, curves, and vertices that no strand uses are problems.
Result<Strands> parseObj(std::string_view text, const std::string& file);

/// The text of an .obj file, without attributes; 9 significant digits, so that what is read again
/// is what was written. A groom without strands is a problem.
Result<std::string> formatObj(const Strands& strands, const std::string& file);

}  // namespace kushi
