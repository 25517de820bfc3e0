// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <kushi/ellipsoid.h>
#include <kushi/result.h>
#include <kushi/style.h>

#include <cstddef>
#include <cstdint>
#include <vector>

namespace kushi {

/// Where hairs leave the scalp (the paper's pores), one entry each.
struct Follicles {
    std::vector<Vec3d> roots;             ///< m, on the ellipsoid
    std::vector<EllipsoidAngles> angles;  ///< rad, of the same points
    std::vector<std::uint64_t> keys;  ///< identity: all that is random about a hair follows from it
    double spacing = 0;               ///< m between neighbours before jitter

    std::size_t size() const { return roots.size(); }
};

/// Follicles all over the scalp's regions (Usami & Anjyo 1992, 2.3).
///
/// Rows of constant theta stand `spacing` apart along the mean meridian (the average over phi of
/// the meridians' lengths); along each row follicles are equally spaced by arc length, starting at
/// a place that the seed chooses. Then each moves by up to +-jitter/2 spacings along both. The
/// regions test the place where that has put it. For a `count` the spacing is searched, and the few
/// follicles in excess are taken out evenly: the number is met exactly.
///
/// Refuses what asks for more than 5,000,000 follicles, or for so little spacing that the whole
/// ellipsoid would bear more than 20,000,000.
Result<Follicles> plant(const Scalp& scalp, std::uint64_t seed);

/// Keeps `count` follicles spread evenly (all, if there are no more), in their former order. What
/// is kept for a smaller count is also kept for a larger one.
///
/// Yuksel, "Sample Elimination for Generating Poisson Disk Sample Sets", Eurographics 2015.
Follicles thin(const Follicles& follicles, std::size_t count);

}  // namespace kushi
