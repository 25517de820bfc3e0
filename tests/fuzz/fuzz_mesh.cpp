// SPDX-License-Identifier: Apache-2.0
#include "io/mesh_file.h"
#include "io/place_mesh.h"
#include "io/weld.h"

#include <cstddef>
#include <cstdint>
#include <cstdlib>
#include <string_view>

// The first byte says which format. Whatever the others, the reader returns; what it returns can
// be placed and welded.
// NOLINTNEXTLINE(readability-identifier-naming)
extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
    using namespace kushi;
    if (size == 0) return 0;
    const std::string_view bytes(reinterpret_cast<const char*>(data) + 1, size - 1);
    constexpr decltype(&parseObjMesh) formats[] = {parseObjMesh, parsePlyMesh, parseStlMesh,
                                                   parseGltfMesh};
    Result<Faces> faces = formats[data[0] % 4](bytes, "fuzz");
    if (!faces) {
        if (faces.problems().size() != 1 || faces.problems()[0].message.empty()) std::abort();
        return 0;
    }
    if (faces->triangles.empty() || !placeMesh(*faces, {}, 0.01).empty()) return 0;
    const Mesh mesh = weld(*faces);
    if (mesh.normals.size() != mesh.vertices.size()) std::abort();
    if (!mesh.uvs.empty() && mesh.uvs.size() != mesh.triangles.size()) std::abort();
    if (!mesh.groups.empty() && mesh.groups.size() != mesh.triangles.size()) std::abort();
    for (const std::uint16_t group : mesh.groups) {
        if (group >= mesh.groupNames.size()) std::abort();
    }
    for (const Vec3f vertex : mesh.vertices) {
        if (!isFinite(vertex)) std::abort();
    }
    return 0;
}
