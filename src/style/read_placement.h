// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "style/table_reader.h"

#include <kushi/mesh_io.h>

namespace kushi {

// The keys that say how the numbers of a mesh or of strands in a file are meant.

/// `unit`: a name or cm; what one unit of the file is [m].
void readFileUnit(const TableReader& table, std::optional<double>& unit);

/// `up` and `front`: axes of the file, at right angles. What stands there before are the defaults.
void readAxes(const TableReader& table, Vec3d& up, Vec3d& front);

/// `mesh`: the path of a file, as the style's folder leads to it, or one of `names`. Whether it is
/// a file's.
bool readMeshPath(const TableReader& table, std::span<const std::string_view> names,
                  std::string& mesh);

/// `unit`, `up`, `front`, `origin` and `offset` of a mesh, which go with a file only.
void readMeshPlacement(const TableReader& table, bool fromFile, MeshPlacement& placement);

}  // namespace kushi
