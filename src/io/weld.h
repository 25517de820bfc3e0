// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "io/faces.h"

#include <kushi/mesh.h>

namespace kushi {

/// The mesh of triangles in metres: identical vertices are one, triangles without an area and
/// vertices without a triangle are left out. Triangles that turn the wrong way round all together
/// are turned, and so are normals. Texture coordinates stay with the corners, so that a seam of the
/// texture is none of the mesh. Where one corner has no normal, all come from the triangles.
Mesh weld(const Faces& faces);

}  // namespace kushi
