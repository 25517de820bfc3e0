// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "trace/hair_point.h"
#include "trace/skin_point.h"
#include "trace/sky.h"

#include <kushi/trace.h>

#include <span>
#include <vector>

namespace kushi {

/// Everything that paths need to know; read by all threads, written by none.
class World {
public:
    World(const Strands& strands, const Mesh& head, std::span<const Rgb> skin, const Lights& lights,
          const TraceLook& look, int threads);

    Meeting first(const Ray& ray) const { return rays_.first(ray); }
    bool blocked(const Ray& ray) const { return rays_.blocked(ray); }
    const Sky& sky() const { return sky_; }
    const FibreModel<float>& fibre() const { return fibre_; }
    const TraceLook& look() const { return look_; }

    /// What a ray has met on a hair.
    HairSpot hairAt(const Meeting& met, const Ray& ray) const;
    /// What it has met on the head.
    SkinSpot skinAt(const Meeting& met, const Ray& ray) const;

private:
    struct Node {
        Vec3f place;
        float radius = 0;
        Vec3f tangent;
        Rgb absorption;
        float tilt = 0;
    };

    std::vector<Node> nodes_;
    const Mesh& head_;
    std::span<const Rgb> skin_;
    TraceLook look_;
    FibreModel<float> fibre_;
    Sky sky_;
    RayScene rays_;
};

struct PathLimits {
    int bounces = 64;
    float clamp = 0;  ///< as in TraceOptions
    float pixel = 0;  ///< how wide a pixel is, as a share of its distance
};

/// What came along one path.
struct Seen {
    Rgb light;
    bool covered = false;  ///< whether there was anything but sky
};

/// Follows light backwards along a ray from the camera. `scratch` is any vector to work in.
Seen follow(const World& world, Ray ray, Sampler& random, PathLimits limits,
            std::vector<float>& scratch);

}  // namespace kushi
