// SPDX-License-Identifier: Apache-2.0
//
// Hair inside of closed meshes, by rays and triangles: what the distance field is not asked for.
#pragma once

#include "geometry/brute_force.h"
#include "geometry/ray_cast.h"

#include <kushi/strands.h>

namespace kushi::test {

/// What is found inside.
struct HairInMesh {
    double deepest = 0;       ///< m
    std::size_t strands = 0;  ///< with a point deeper than 0.1 mm
    std::uint32_t worst = 0;  ///< the strand with the deepest point,
    Vec3d place;              ///< and that
};

/// A closed mesh whose triangles face outwards, as something that hair may be in.
class SolidMesh {
public:
    explicit SolidMesh(const Mesh& mesh) : mesh_(mesh), rays_(mesh) {
        for (const Vec3f vertex : mesh.vertices)
            reach_ = std::max(reach_, length(vertex.as<double>()));
    }

    /// Whether most of three rays meet first what faces away.
    bool contains(Vec3d place) const {
        if (length(place) > reach_) return false;
        int votes = 0;
        for (const Vec3d way :
             {Vec3d{0.31, 0.93, 0.2}, Vec3d{-0.7, 0.1, 0.71}, Vec3d{0.2, 0.4, -0.9}}) {
            const auto hit = rays_.first(place, place + 3 * reach_ * way);
            votes += hit && dot(hit->normal, way) > 0 ? 1 : 0;
        }
        return votes >= 2;
    }

    /// The deepest of 8 points on each segment and the tip [m]. Within 3 mm of the root nothing
    /// counts: it may lie on the skin. A strand that meets no triangle beyond is not looked at
    /// twice.
    double depth(std::span<const Vec3f> nodes, Vec3d* place = nullptr) const {
        if (!meets(nodes)) return 0;
        double deepest = 0;
        double walked = 0;
        for (std::size_t j = 1; j < nodes.size(); ++j) {
            const Vec3d from = nodes[j - 1].as<double>();
            const Vec3d way = nodes[j].as<double>() - from;
            for (int k = 1; k <= 8; ++k) {
                const Vec3d at = from + (k / 8.0) * way;
                if (walked + k / 8.0 * length(way) < nearRoot || !contains(at)) continue;
                const double depth = distanceToMesh(mesh_, at);
                if (depth <= deepest) continue;
                deepest = depth;
                if (place != nullptr) *place = at;
            }
            walked += length(way);
        }
        return deepest;
    }

    HairInMesh find(const Strands& groom) const {
        HairInMesh found;
        for (std::uint32_t i = 0; i < groom.size(); ++i) {
            Vec3d place;
            const double deep = depth(groom.strand(i), &place);
            found.strands += deep > 1e-4 ? 1 : 0;
            if (deep <= found.deepest) continue;
            found.deepest = deep;
            found.worst = i;
            found.place = place;
        }
        return found;
    }

private:
    static constexpr double nearRoot = 0.003;

    // Whether a strand's tip is inside, or any of its segments meets a triangle.
    bool meets(std::span<const Vec3f> nodes) const {
        for (std::size_t j = 1; j < nodes.size(); ++j) {
            if (rays_.first(nodes[j - 1].as<double>(), nodes[j].as<double>())) return true;
        }
        return contains(nodes.back().as<double>());
    }

    const Mesh& mesh_;
    RayCaster rays_;
    double reach_ = 0;
};

}  // namespace kushi::test
