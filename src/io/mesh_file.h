// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "io/faces.h"

#include <kushi/result.h>

#include <string>
#include <string_view>

namespace kushi {

// Readers of our own, as Assimp 5.2.5 crashes, hangs and prints on damaged OBJ and PLY files and
// hangs on GLB.
//
// The mesh in the bytes of a file; `file` stands in the problems. Polygons become triangles, what
// is no surface (colours, lines) is passed over. There may be no triangle at all.

Result<Faces> parseObjMesh(std::string_view bytes, const std::string& file);
Result<Faces> parsePlyMesh(std::string_view bytes, const std::string& file);
Result<Faces> parseStlMesh(std::string_view bytes, const std::string& file);
/// Both .gltf and .glb; buffers in files of their own are read from the folder of `file`.
Result<Faces> parseGltfMesh(std::string_view bytes, const std::string& file);

}  // namespace kushi
