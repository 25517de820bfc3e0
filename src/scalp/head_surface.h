// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "geometry/ray_cast.h"

#include <kushi/image.h>
#include <kushi/result.h>
#include <kushi/style.h>

#include <optional>

namespace kushi {

/// A head's mesh as the surface that hair grows from: points of the scalp's ellipsoid are carried
/// to it, along the lines to the ellipsoid's centre.
class HeadSurface {
public:
    /// How far outside of the ellipsoid the head may lie [m].
    static constexpr double reach = 0.02;

    /// A point of the ellipsoid on the head.
    struct Place {
        Vec3d point;       ///< m
        Vec3d normal;      ///< unit, outwards, blended between the mesh's vertices
        Vec3d flatNormal;  ///< of the triangle alone
        double share = 1;  ///< of hair that grows there, by the mask; not a number without texture
                           ///< coordinates
    };

    /// What a scalp's groups and mask make of a head. The head must outlive it.
    static Result<HeadSurface> of(const Scalp& scalp, const Mesh& head);

    /// The outermost surface on the line through a point of the ellipsoid; none if there is none.
    std::optional<Place> at(Vec3d point) const;

private:
    HeadSurface(const Scalp& scalp, const Mesh& head, const std::vector<bool>& marked)
        : center_(scalp.ellipsoid.center), head_(head), caster_(head, marked) {}

    double shareAt(const RayHit& hit) const;

    Vec3d center_;
    const Mesh& head_;
    RayCaster caster_;
    std::optional<GreyImage> mask_;
};

}  // namespace kushi
