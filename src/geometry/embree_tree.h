// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "core/parallel.h"

#include <kushi/mesh.h>

#include <algorithm>
#include <array>
#include <cstdint>
#include <new>
#include <span>

#include <embree3/rtcore.h>

namespace kushi {

/// Embree's device and scene, released in the end. What Embree cannot do for want of memory throws
/// std::bad_alloc.
class EmbreeTree {
public:
    /// config  as rtcNewDevice() takes it; not its `threads`, which hold for all of the program
    explicit EmbreeTree(const char* config) : device_(rtcNewDevice(config)) {
        if (device_ == nullptr) throw std::bad_alloc();
        scene_ = rtcNewScene(device_);
    }
    EmbreeTree(const EmbreeTree&) = delete;
    EmbreeTree& operator=(const EmbreeTree&) = delete;
    ~EmbreeTree() {
        if (scene_ != nullptr) rtcReleaseScene(scene_);
        rtcReleaseDevice(device_);
    }

    RTCDevice device() const { return device_; }
    RTCScene scene() const { return scene_; }

    /// Room for `count` things of a geometry, each `Item` large.
    template <class Item>
    Item* room(RTCGeometry geometry, RTCBufferType type, RTCFormat format,
               std::size_t count) const {
        void* const first = rtcSetNewGeometryBuffer(geometry, type, 0, format, sizeof(Item), count);
        if (first == nullptr) {
            rtcReleaseGeometry(geometry);
            throw std::bad_alloc();
        }
        return static_cast<Item*>(first);
    }

    /// Those triangles of a mesh; returns the geometry's number.
    unsigned addTriangles(const Mesh& mesh, std::span<const std::uint32_t> triangles) {
        RTCGeometry geometry = rtcNewGeometry(device_, RTC_GEOMETRY_TYPE_TRIANGLE);
        auto* const points =
            room<Vec3f>(geometry, RTC_BUFFER_TYPE_VERTEX, RTC_FORMAT_FLOAT3, mesh.vertices.size());
        using Corners = std::array<std::uint32_t, 3>;
        auto* corners =
            room<Corners>(geometry, RTC_BUFFER_TYPE_INDEX, RTC_FORMAT_UINT3, triangles.size());
        std::ranges::copy(mesh.vertices, points);
        for (const std::uint32_t i : triangles)
            *corners++ = mesh.triangles[i];
        return add(geometry);
    }

    /// Takes a geometry whose buffers are full; returns its number.
    unsigned add(RTCGeometry geometry) {
        rtcCommitGeometry(geometry);
        const unsigned number = rtcAttachGeometry(scene_, geometry);
        rtcReleaseGeometry(geometry);
        return number;
    }

    /// Builds the tree over all that was added.
    ///
    /// threads  0: as many as the machine has
    void build(int threads) {
        withThreads(threads, [&] { rtcCommitScene(scene_); });
        if (rtcGetDeviceError(device_) != RTC_ERROR_NONE) throw std::bad_alloc();
    }

private:
    RTCDevice device_;
    RTCScene scene_ = nullptr;
};

}  // namespace kushi
