// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <kushi/mesh.h>
#include <kushi/strands.h>

#include <cstdint>
#include <memory>
#include <span>

namespace kushi {

struct Ray {
    Vec3f origin;     ///< m
    Vec3f direction;  ///< unit
    float from = 0;   ///< m along it, what is nearer does not count
};

/// What a ray meets first.
struct Meeting {
    enum class Kind { Nothing, Hair, Head };
    Kind kind = Kind::Nothing;
    /// Hair: the segment's first node. Head: the triangle.
    std::uint32_t which = 0;
    float distance = 0;  ///< m
    /// Hair: u is how far along the segment. Head: weights of the second and the third corner.
    float u = 0, v = 0;
};

/// Strands and a head for rays to meet. A segment is a ribbon as wide as the hair that always faces
/// the ray, which is what a round hair looks like. No other file knows the library behind it.
class RayScene {
public:
    /// Leaves out what is not finite.
    ///
    /// diameters  m, per node of the strands
    /// threads    to build with; 0: as many as the machine has
    RayScene(const Strands& strands, std::span<const float> diameters, const Mesh& head,
             int threads);

    Meeting first(const Ray& ray) const;
    bool blocked(const Ray& ray) const;

private:
    struct Tree;
    std::shared_ptr<const Tree> tree_;
};

}  // namespace kushi
