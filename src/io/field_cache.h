// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <kushi/distance_field.h>

#include <cstdint>
#include <functional>
#include <span>
#include <string>

namespace kushi {

/// A name for what distanceFieldOf() makes of these: 32 hexadecimal digits that follow from places
/// and triangles, offsets and spacing, and from how this version of Kushi computes fields.
std::string fieldName(std::span<const Solid> solids, const DistanceFieldOptions& options);

/// The same of one mesh that is known by a number of its own.
std::string fieldName(std::uint64_t meshKey, double offset);

/// The field of a name, from `folder` if it was put there before; else made, and put there. The
/// folder is made if there is none. One that cannot be written is no problem, nor is a damaged file
/// in it: the field is made. So it is if `folder` is empty.
Result<DistanceField> cachedField(const std::string& name, const std::string& folder,
                                  const std::function<Result<DistanceField>()>& make);

}  // namespace kushi
