// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <kushi/distance_field.h>

#include <span>
#include <string>
#include <string_view>

namespace kushi {

// A distance field takes longer to compute than to read. Its file, `.field`, is Kushi's own: a
// header of 56 bytes (kushi's mark, version, place, spacing, size, whether nearest solids follow,
// a checksum), then the samples as they are in memory, little-endian. Not compressed: reading would
// take several times as long.

/// The field in the bytes of a file. Bytes that are not such a file, of another version, cut short,
/// too many or damaged are a problem.
Result<DistanceField> parseField(std::string_view bytes, const std::string& file);

/// The bytes of a file.
std::string formatField(const DistanceField& field);

/// parseField() of a file of 1 GiB at most.
Result<DistanceField> readField(const std::string& path);

/// formatField() into a file that appears whole or not at all.
Status writeField(const std::string& path, const DistanceField& field);

}  // namespace kushi
