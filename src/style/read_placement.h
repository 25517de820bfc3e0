// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "style/table_reader.h"

namespace kushi {

// The keys that say how the numbers of a mesh or of strands in a file are meant.

/// `unit`: a name or cm; what one unit of the file is [m].
void readFileUnit(const TableReader& table, std::optional<double>& unit);

/// `up` and `front`: axes of the file, at right angles. What stands there before are the defaults.
void readAxes(const TableReader& table, Vec3d& up, Vec3d& front);

}  // namespace kushi
