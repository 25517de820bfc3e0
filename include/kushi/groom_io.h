// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <kushi/result.h>
#include <kushi/strands.h>

#include <optional>
#include <string>

namespace kushi {

/// How the numbers of a strand file become a groom in Kushi's axes: turned, scaled, then moved.
struct GroomPlacement {
    /// m that one unit of the file is, > 0; left out, it is the format's: 1 cm. Diameters as well.
    std::optional<double> unit;
    Vec3d up = {0, 1, 0};     ///< in the file's axes; one of them, or one reversed
    Vec3d front = {1, 0, 0};  ///< the way the face looks, likewise; at right angles to up
    Vec3d offset;             ///< added at the end [m], in Kushi's axes
};

/// Whether the extension of `path` is one that readGroom and writeGroom know: .hair, .ply or .obj,
/// in capitals or not.
bool isGroomPath(const std::string& path);

/// Reads a groom; the format follows from the extension, in capitals or not. Files are in
/// centimetres, y up. Keys are not stored in any format: what is read has none.
///
/// A file that is truncated, contradicts itself or holds a number that is not finite is a problem
/// that says where and what was expected; nothing is guessed. Counts are checked against the size
/// of the file before memory is taken for them.
Result<Strands> readGroom(const std::string& path);
/// The same, put in its place. A placement that leaves nodes where no float reaches is a problem.
Result<Strands> readGroom(const std::string& path, const GroomPlacement& placement);

/// Writes a groom; the format follows from the extension. The file appears whole or not at all.
///
/// .hair cannot hold a strand of one node or of more than 65,536, nor .obj a groom without strands:
/// problems found before anything is written. What else a format cannot hold (.obj: attributes) is
/// left out; docs/formats.md says what each keeps. An output that cannot be written is a problem
/// with `system` set.
Status writeGroom(const Strands& strands, const std::string& path);

}  // namespace kushi
