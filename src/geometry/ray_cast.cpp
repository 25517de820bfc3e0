// SPDX-License-Identifier: Apache-2.0
#include "geometry/ray_cast.h"

#include "geometry/embree_tree.h"

#include <algorithm>
#include <optional>

namespace kushi {

/// Embree's tree over the triangles, and which of the mesh's each is.
struct RayCaster::Scene {
    const Mesh& mesh;
    std::vector<std::uint32_t> triangles;
    std::optional<EmbreeTree> tree;  // none without triangles

    explicit Scene(const Mesh& of) : mesh(of) {}

    void build() {
        // The narrowest registers, so that every processor finds the same.
        tree.emplace("isa=sse2");
        rtcSetSceneFlags(tree->scene(), RTC_SCENE_FLAG_ROBUST);
        tree->addTriangles(mesh, triangles);
        tree->build(1);
    }
};

RayCaster::RayCaster(const Mesh& mesh, const std::vector<bool>& marked) {
    const auto scene = std::make_shared<Scene>(mesh);
    for (std::uint32_t i = 0; i < mesh.triangles.size(); ++i) {
        if (marked.empty() || marked[i]) scene->triangles.push_back(i);
    }
    if (!scene->triangles.empty()) scene->build();
    scene_ = scene;
}

std::optional<RayHit> RayCaster::first(Vec3d from, Vec3d to) const {
    if (!scene_->tree) return std::nullopt;
    const Vec3d way = to - from;
    RTCRayHit query = {};
    query.ray.org_x = static_cast<float>(from.x);
    query.ray.org_y = static_cast<float>(from.y);
    query.ray.org_z = static_cast<float>(from.z);
    query.ray.dir_x = static_cast<float>(way.x);
    query.ray.dir_y = static_cast<float>(way.y);
    query.ray.dir_z = static_cast<float>(way.z);
    query.ray.tfar = 1;
    query.ray.mask = ~0U;
    query.hit.geomID = RTC_INVALID_GEOMETRY_ID;
    RTCIntersectContext context;
    rtcInitIntersectContext(&context);
    rtcIntersect1(scene_->tree->scene(), &context, &query);
    if (query.hit.geomID == RTC_INVALID_GEOMETRY_ID) return std::nullopt;

    // Embree says which triangle; where on it, more accurately, is the plane's business.
    RayHit hit;
    hit.triangle = scene_->triangles[query.hit.primID];
    const auto& corners = scene_->mesh.triangles[hit.triangle];
    const auto at = [&](std::size_t k) { return scene_->mesh.vertices[corners[k]].as<double>(); };
    const Vec3d b = at(1) - at(0);
    const Vec3d c = at(2) - at(0);
    const Vec3d across = cross(b, c);
    const double size = length(across);
    const double slope = dot(across, way);
    if (!(size > 0) || slope == 0) return std::nullopt;
    const Vec3d inPlane = dot(across, at(0) - from) / slope * way + from - at(0);
    const double second = std::clamp(dot(cross(inPlane, c), across) / (size * size), 0.0, 1.0);
    const double third =
        std::clamp(dot(cross(b, inPlane), across) / (size * size), 0.0, 1.0 - second);
    hit.weights = {1 - second - third, second, third};
    hit.point = at(0) + second * b + third * c;
    hit.normal = across / size;
    return hit;
}

}  // namespace kushi
