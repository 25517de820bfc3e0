// SPDX-License-Identifier: Apache-2.0
#include "trace/ray_scene.h"

#include "geometry/embree_tree.h"

#include <algorithm>
#include <array>
#include <limits>
#include <vector>

namespace kushi {

namespace {

RTCRay rayOf(const Ray& ray) {
    RTCRay query = {};
    query.org_x = ray.origin.x;
    query.org_y = ray.origin.y;
    query.org_z = ray.origin.z;
    query.dir_x = ray.direction.x;
    query.dir_y = ray.direction.y;
    query.dir_z = ray.direction.z;
    query.tnear = ray.from;
    query.tfar = std::numeric_limits<float>::infinity();
    query.mask = ~0U;
    return query;
}

/// The first nodes of the segments to be met.
std::vector<std::uint32_t> segmentsOf(const Strands& strands, std::span<const float> diameters) {
    const auto usable = [&](std::uint32_t node) {
        return isFinite(strands.nodes[node]) && std::isfinite(diameters[node]) &&
               diameters[node] >= 0;
    };
    std::vector<std::uint32_t> segments;
    segments.reserve(strands.segmentCount());
    for (std::size_t i = 0; i < strands.size(); ++i) {
        for (std::uint32_t node = strands.offsets[i]; node + 1 < strands.offsets[i + 1]; ++node) {
            if (usable(node) && usable(node + 1) && strands.nodes[node] != strands.nodes[node + 1])
                segments.push_back(node);
        }
    }
    return segments;
}

/// The triangles to be met.
std::vector<std::uint32_t> trianglesOf(const Mesh& head) {
    std::vector<std::uint32_t> triangles;
    triangles.reserve(head.triangles.size());
    for (std::uint32_t i = 0; i < head.triangles.size(); ++i) {
        if (std::ranges::all_of(head.triangles[i], [&](std::uint32_t corner) {
                return isFinite(head.vertices[corner]);
            })) {
            triangles.push_back(i);
        }
    }
    return triangles;
}

}  // namespace

/// Embree's tree, and what its numbers stand for.
struct RayScene::Tree {
    EmbreeTree embree{"set_affinity=0"};
    std::vector<std::uint32_t> segments, triangles;
    unsigned hair = RTC_INVALID_GEOMETRY_ID;  // Embree's number of the geometry

    void addHair(const Strands& strands, std::span<const float> diameters) {
        RTCGeometry geometry = rtcNewGeometry(embree.device(), RTC_GEOMETRY_TYPE_FLAT_LINEAR_CURVE);
        using Node = std::array<float, 4>;
        auto* const nodes = embree.room<Node>(geometry, RTC_BUFFER_TYPE_VERTEX, RTC_FORMAT_FLOAT4,
                                              strands.nodes.size());
        auto* const starts = embree.room<std::uint32_t>(geometry, RTC_BUFFER_TYPE_INDEX,
                                                        RTC_FORMAT_UINT, segments.size());
        for (std::size_t i = 0; i < strands.nodes.size(); ++i) {
            const Vec3f node = strands.nodes[i];
            nodes[i] = {node.x, node.y, node.z, diameters[i] / 2};
        }
        std::ranges::copy(segments, starts);
        hair = embree.add(geometry);
    }
};

RayScene::RayScene(const Strands& strands, std::span<const float> diameters, const Mesh& head,
                   int threads) {
    const auto tree = std::make_shared<Tree>();
    tree->segments = segmentsOf(strands, diameters);
    tree->triangles = trianglesOf(head);
    if (!tree->segments.empty()) tree->addHair(strands, diameters);
    if (!tree->triangles.empty()) tree->embree.addTriangles(head, tree->triangles);
    tree->embree.build(threads);
    tree_ = tree;
}

Meeting RayScene::first(const Ray& ray) const {
    RTCRayHit query = {};
    query.ray = rayOf(ray);
    query.hit.geomID = RTC_INVALID_GEOMETRY_ID;
    RTCIntersectContext context;
    rtcInitIntersectContext(&context);
    rtcIntersect1(tree_->embree.scene(), &context, &query);
    const RTCHit& hit = query.hit;
    if (hit.geomID == RTC_INVALID_GEOMETRY_ID) return {};
    if (hit.geomID == tree_->hair) {
        return {Meeting::Kind::Hair, tree_->segments[hit.primID], query.ray.tfar, hit.u, hit.v};
    }
    return {Meeting::Kind::Head, tree_->triangles[hit.primID], query.ray.tfar, hit.u, hit.v};
}

bool RayScene::blocked(const Ray& ray) const {
    RTCRay query = rayOf(ray);
    RTCIntersectContext context;
    rtcInitIntersectContext(&context);
    rtcOccluded1(tree_->embree.scene(), &context, &query);
    return query.tfar < 0;
}

}  // namespace kushi
