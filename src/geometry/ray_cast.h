// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <kushi/mesh.h>

#include <array>
#include <memory>
#include <optional>

namespace kushi {

/// Where a line meets a triangle.
struct RayHit {
    std::uint32_t triangle = 0;       ///< index of the mesh's
    std::array<double, 3> weights{};  ///< of its corners, adding up to 1
    Vec3d point;                      ///< m
    Vec3d normal;                     ///< of the triangle, unit
};

/// Finds what lines meet first of some triangles; no other file knows the library behind it.
class RayCaster {
public:
    /// Of a mesh's triangles those marked, or all if `marked` is empty. The mesh must outlive it.
    explicit RayCaster(const Mesh& mesh, const std::vector<bool>& marked = {});

    /// The first triangle, seen from either side, on the way from one point to the other.
    std::optional<RayHit> first(Vec3d from, Vec3d to) const;

private:
    struct Scene;
    std::shared_ptr<const Scene> scene_;
};

}  // namespace kushi
