// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <kushi/mesh.h>
#include <kushi/result.h>

#include <optional>
#include <string>

namespace kushi {

/// What comes to rest at Kushi's origin, the middle of headEllipsoid().
enum class MeshOrigin {
    /// The mesh is moved to stand as the mannequin does: its highest point as high as the
    /// mannequin's crown, the 12 cm below it in the middle from left to right and from front to
    /// back.
    Crown,
    /// The file's own origin.
    File,
};

/// How the numbers of a mesh file become a head in Kushi's axes.
struct MeshPlacement {
    /// m that one unit of the file is, > 0; left out, it is the format's: 1 m in glTF, else 1 cm.
    std::optional<double> unit;
    Vec3d up = {0, 1, 0};     ///< in the file's axes; one of them, or one reversed
    Vec3d front = {0, 0, 1};  ///< the way the face looks, likewise; at right angles to up
    MeshOrigin origin = MeshOrigin::Crown;
    Vec3d offset;               ///< added at the end [m], in Kushi's axes
    double leastHeight = 0.15;  ///< a lower mesh is a problem: no head, or in another unit [m]
};

/// Whether the extension of `path` is one that readMesh knows: .obj, .ply, .stl, .gltf or .glb, in
/// capitals or not.
bool isMeshPath(const std::string& path);

/// Reads a head, or a whole figure; the format follows from the extension.
///
/// All meshes of the file become one, as its nodes place them. Polygons become triangles,
/// identical vertices one. Triangles and normals are turned outwards; normals come from the
/// triangles where the file lacks any, and always in STL. There are no colours. Texture coordinates
/// and groups come from .obj (vt; o, g and usemtl) and glTF (TEXCOORD_0; names of nodes, meshes and
/// materials).
///
/// A file that is truncated, contradicts itself, has no faces or holds a position that is not
/// finite is a problem that says where; so is a mesh that is lower than leastHeight or more than
/// 250 cm high, with the unit that it may be in. Counts are checked against the size of the file
/// before memory is taken.
Result<Mesh> readMesh(const std::string& path, const MeshPlacement& placement = {});

}  // namespace kushi
