// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "io/faces.h"

#include <kushi/mesh_io.h>

#include <string>

namespace kushi {

/// Turns a mesh, which has triangles, into Kushi's axes and metres and puts it in its place;
/// `unit` [m] is that of the format. What is wrong with its size, or nothing.
std::string placeMesh(Faces& faces, const MeshPlacement& placement, double unit);

}  // namespace kushi
