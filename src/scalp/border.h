// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "scalp/point_tree.h"

#include <kushi/style.h>

#include <vector>

namespace kushi {

/// Where the regions of a scalp end, as points of the line that are no farther apart than a sixth
/// of its `edge`, or a thousandth of a turn. Of regions narrower than a degree some may be missed.
class Border {
public:
    explicit Border(const Scalp& scalp);
    Border(const Border&) = delete;
    Border& operator=(const Border&) = delete;

    /// Of the follicles at a place of the ellipsoid's surface inside of the regions, the share that
    /// grows: 1 from `scalp.edge` off the border on, linearly less towards it.
    double share(Vec3d place) const;

private:
    double edge_;
    std::vector<Vec3d> points_;
    PointCloud cloud_;
    PointTree tree_;
};

}  // namespace kushi
