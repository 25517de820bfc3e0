// SPDX-License-Identifier: Apache-2.0
#include "trace/ray_scene.h"

#include <algorithm>
#include <array>
#include <limits>
#include <new>
#include <utility>
#include <vector>

#include <embree3/rtcore.h>

namespace kushi {

namespace {

/// Any call that Embree could not fulfil.
void throwIfFailed(RTCDevice device) {
    if (rtcGetDeviceError(device) != RTC_ERROR_NONE) throw std::bad_alloc();
}

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
    RTCDevice device = nullptr;
    RTCScene scene = nullptr;
    std::vector<std::uint32_t> segments, triangles;
    unsigned hair = RTC_INVALID_GEOMETRY_ID;  // Embree's number of the geometry

    Tree() = default;
    Tree(const Tree&) = delete;
    Tree& operator=(const Tree&) = delete;
    ~Tree() {
        if (scene != nullptr) rtcReleaseScene(scene);
        if (device != nullptr) rtcReleaseDevice(device);
    }

    void start() {
        device = rtcNewDevice("set_affinity=0");
        if (device == nullptr) throw std::bad_alloc();
        scene = rtcNewScene(device);
    }

    void addHair(const Strands& strands, std::span<const float> diameters) {
        if (segments.empty()) return;
        RTCGeometry geometry = rtcNewGeometry(device, RTC_GEOMETRY_TYPE_FLAT_LINEAR_CURVE);
        auto* nodes = static_cast<float*>(
            rtcSetNewGeometryBuffer(geometry, RTC_BUFFER_TYPE_VERTEX, 0, RTC_FORMAT_FLOAT4,
                                    4 * sizeof(float), strands.nodes.size()));
        auto* starts = static_cast<std::uint32_t*>(
            rtcSetNewGeometryBuffer(geometry, RTC_BUFFER_TYPE_INDEX, 0, RTC_FORMAT_UINT,
                                    sizeof(std::uint32_t), segments.size()));
        throwIfFailed(device);
        for (std::size_t i = 0; i < strands.nodes.size(); ++i) {
            const Vec3f node = strands.nodes[i];
            nodes =
                std::ranges::copy(std::array{node.x, node.y, node.z, diameters[i] / 2}, nodes).out;
        }
        std::ranges::copy(segments, starts);
        hair = attach(geometry);
    }

    void addHead(const Mesh& head) {
        if (triangles.empty()) return;
        RTCGeometry geometry = rtcNewGeometry(device, RTC_GEOMETRY_TYPE_TRIANGLE);
        auto* points = static_cast<Vec3f*>(
            rtcSetNewGeometryBuffer(geometry, RTC_BUFFER_TYPE_VERTEX, 0, RTC_FORMAT_FLOAT3,
                                    sizeof(Vec3f), head.vertices.size()));
        auto* corners = static_cast<std::uint32_t*>(
            rtcSetNewGeometryBuffer(geometry, RTC_BUFFER_TYPE_INDEX, 0, RTC_FORMAT_UINT3,
                                    3 * sizeof(std::uint32_t), triangles.size()));
        throwIfFailed(device);
        std::ranges::copy(head.vertices, points);
        for (const std::uint32_t i : triangles)
            corners = std::ranges::copy(head.triangles[i], corners).out;
        attach(geometry);
    }

    void finish() {
        rtcCommitScene(scene);
        throwIfFailed(device);
    }

private:
    unsigned attach(RTCGeometry geometry) {
        rtcCommitGeometry(geometry);
        const unsigned number = rtcAttachGeometry(scene, geometry);
        rtcReleaseGeometry(geometry);
        return number;
    }
};

RayScene::RayScene(const Strands& strands, std::span<const float> diameters, const Mesh& head) {
    const auto tree = std::make_shared<Tree>();
    tree->segments = segmentsOf(strands, diameters);
    tree->triangles = trianglesOf(head);
    tree->start();
    tree->addHair(strands, diameters);
    tree->addHead(head);
    tree->finish();
    tree_ = tree;
}

Meeting RayScene::first(const Ray& ray) const {
    RTCRayHit query = {};
    query.ray = rayOf(ray);
    query.hit.geomID = RTC_INVALID_GEOMETRY_ID;
    RTCIntersectContext context;
    rtcInitIntersectContext(&context);
    rtcIntersect1(tree_->scene, &context, &query);
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
    rtcOccluded1(tree_->scene, &context, &query);
    return query.tfar < 0;
}

}  // namespace kushi
