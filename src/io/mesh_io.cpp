// SPDX-License-Identifier: Apache-2.0
#include "io/extension.h"
#include "io/file_limit.h"
#include "io/mesh_file.h"
#include "io/place_mesh.h"
#include "io/text.h"
#include "io/weld.h"

#include <kushi/mesh_io.h>

#include <algorithm>
#include <array>
#include <new>
#include <string_view>
#include <utility>

namespace kushi {
namespace {

struct Format {
    std::string_view extension;
    Result<Faces> (*parse)(std::string_view bytes, const std::string& file);
    double unit;  ///< m
};

constexpr std::array<Format, 5> formats = {{
    {".obj", parseObjMesh, 0.01},
    {".ply", parsePlyMesh, 0.01},
    {".stl", parseStlMesh, 0.01},
    {".gltf", parseGltfMesh, 1},
    {".glb", parseGltfMesh, 1},
}};

const Format* formatOf(const std::string& path) {
    const auto* const found = std::ranges::find(formats, lowerExtension(path), &Format::extension);
    return found == formats.end() ? nullptr : found;
}

}  // namespace

bool isMeshPath(const std::string& path) {
    return formatOf(path) != nullptr;
}

Result<Mesh> readMesh(const std::string& path, const MeshPlacement& placement) try {
    const Format* format = formatOf(path);
    if (format == nullptr) {
        return badFile(path,
                       "not a kind of mesh that Kushi reads; expected .obj, .ply, .stl, "
                       ".gltf or .glb");
    }
    const Result<std::string> bytes = readLimitedFile(path, mostBytes);
    if (!bytes) return bytes.problems();
    if (bytes->empty()) return badFile(path, "the file is empty");
    Result<Faces> faces = format->parse(*bytes, path);
    if (!faces) return faces.problems();
    if (faces->triangles.empty()) {
        return badFile(path, "no faces in " + std::to_string(faces->points.size()) +
                                 " vertices; a head is a mesh of faces");
    }
    if (std::string fault = placeMesh(*faces, placement, format->unit); !fault.empty()) {
        return badFile(path, std::move(fault));
    }
    Mesh mesh = weld(*faces);
    if (mesh.triangles.empty()) return badFile(path, "no face has an area");
    return mesh;
} catch (const std::bad_alloc&) {
    return Problem{.message = "not enough memory for this mesh", .file = path, .system = true};
}

}  // namespace kushi
