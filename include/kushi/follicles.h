// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <kushi/ellipsoid.h>
#include <kushi/mesh.h>
#include <kushi/result.h>
#include <kushi/style.h>

#include <cstddef>
#include <cstdint>
#include <vector>

namespace kushi {

/// Where hairs leave the scalp (the paper's pores), one entry each.
struct Follicles {
    std::vector<Vec3d> roots;             ///< m, on the scalp's surface
    std::vector<Vec3d> normals;           ///< of the surface there, unit, outwards
    std::vector<EllipsoidAngles> angles;  ///< rad, of the points on the ellipsoid
    std::vector<std::uint64_t> keys;  ///< identity: all that is random about a hair follows from it
    std::vector<float> shares;  ///< what mask and edge leave of the follicles there, in (0, 1]; or
                                ///< empty: all
    double spacing = 0;         ///< m between neighbours before jitter, where all are left

    std::size_t size() const { return roots.size(); }
};

/// Follicles all over the scalp's regions (Usami & Anjyo 1992, 2.3).
///
/// Rows of constant theta stand `spacing` apart along the mean meridian (the average over phi of
/// the meridians' lengths); along each row follicles are equally spaced by arc length, starting at
/// a place that the seed chooses. Then each moves by up to +-jitter/2 spacings along both. The
/// regions test the place where that has put it. For a `count` the spacing is searched, and the few
/// follicles in excess are taken out evenly: the number is met exactly. Towards the regions' border
/// follicles become less, by the scalp's `edge`.
///
/// On the surface of a head follicles stand as they do on the ellipsoid, but for what follows.
/// Distances are those on the head: rows stand `spacing` apart along its mean meridian, and along a
/// row each follicle has an area of spacing^2. Each is carried along the line to the ellipsoid's
/// centre, to the outermost of the head's triangles (of the scalp's groups) from 2 cm outside of
/// the ellipsoid on; where there is none, none grows. A mask leaves out a follicle by its key.
///
/// head  that the scalp's surface may be; on the ellipsoid it does not count
///
/// Refuses what asks for more than 5,000,000 follicles, or for so little spacing that the whole
/// ellipsoid would bear more than 20,000,000; groups and masks that do not go with the head; and a
/// head that lies nowhere under the regions.
Result<Follicles> plant(const Scalp& scalp, std::uint64_t seed, const Mesh& head = {});

/// Keeps `count` follicles spread evenly (all, if there are no more), in their former order. What
/// is kept for a smaller count is also kept for a larger one. What is sparse by a mask stays as
/// much sparser.
///
/// Yuksel, "Sample Elimination for Generating Poisson Disk Sample Sets", Eurographics 2015.
Follicles thin(const Follicles& follicles, std::size_t count);

}  // namespace kushi
