// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <kushi/vec.h>

#include <cstddef>
#include <span>

#include <nanoflann.hpp>

namespace kushi {

/// Points as nanoflann asks for them, by the names it asks for.
// NOLINTBEGIN(readability-identifier-naming)
struct PointCloud {
    std::span<const Vec3d> points;

    std::size_t kdtree_get_point_count() const { return points.size(); }
    double kdtree_get_pt(std::size_t i, std::size_t axis) const {
        const Vec3d& point = points[i];
        return axis == 0 ? point.x : (axis == 1 ? point.y : point.z);
    }
    template <class Box>
    bool kdtree_get_bbox(Box& /*box*/) const {
        return false;
    }
};
// NOLINTEND(readability-identifier-naming)

/// Finds points near a place.
using PointTree =
    nanoflann::KDTreeSingleIndexAdaptor<nanoflann::L2_Simple_Adaptor<double, PointCloud>,
                                        PointCloud, 3, std::size_t>;

}  // namespace kushi
