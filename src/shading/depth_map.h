// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <kushi/mesh.h>

#include <vector>

namespace kushi {

/// A mesh seen from a light far away: what it hides from the light.
class DepthMap {
public:
    /// Of nothing.
    DepthMap() = default;
    /// towardsLight  unit
    /// texel         edge of the map's squares [m], > 0
    DepthMap(const Mesh& mesh, Vec3f towardsLight, float texel);

    /// Share of the light that reaches a place, in [0, 1]. What lies less than `slack` [m] behind
    /// the mesh is lit, more than three times that is not; across the light shadows have edges a
    /// texel or two wide.
    float lit(Vec3f place, float slack) const;

private:
    struct Place {
        float u, v;   // texels
        float depth;  // towards the light [m]
    };
    Place project(Vec3f point) const {
        return {(dot(point, right_) - left_) / texel_, (dot(point, up_) - bottom_) / texel_,
                dot(point, towards_)};
    }
    void cover(const Place& a, const Place& b, const Place& c);

    Vec3f towards_, right_, up_;
    float texel_ = 1;
    float left_ = 0, bottom_ = 0;  // of the map's first square's middle [m]
    int width_ = 0, height_ = 0;
    std::vector<float> nearest_;  // depth of the mesh
};

}  // namespace kushi
