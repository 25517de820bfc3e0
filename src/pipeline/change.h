// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <kushi/rest_shape.h>

#include <functional>
#include <span>
#include <vector>

namespace kushi {

/// How hair and what acts on it differ from what a groom was set under: gravity alone.
struct Change {
    Vec3d setGravity = {0, -1, 0};  ///< times the earth's
    Vec3d gravity = {0, -1, 0};     ///< that it is then under, times the earth's
    double weight = 1;              ///< times that it was set with, > 0
    double bending = 1;             ///< EI likewise
    double twisting = 1;            ///< GJ likewise
    double set = 1;                 ///< share of the natural shape that stays, in [0, 1]
    std::span<const Force> forces = {};
    std::span<const float> rootShares = {};  ///< of each strand in each force, strand by strand
    /// As in RodWorld: what is in its way, already where it was set.
    const DistanceField* solids = nullptr;
    std::span<const float> solidFrictions = {};
    std::span<const Layer> layers = {};
};

/// A set groom after a change.
struct ChangedGroom {
    Rods rods;                 ///< with all of the change; they start where they rest
    std::vector<Vec3f> nodes;  ///< of the rods [m]
    RestReport report;
};

/// Brings a set groom to rest under a change. It is made in small steps from the groom as it is,
/// and each strand takes the rest that this leads to. What was added to a strand's stiffness to
/// hold its shape goes with the share of that shape which stays.
///
/// progress  told the share done, in [0, 1]; may be empty
ChangedGroom settleChanged(const SetGroom& set, const Change& change, int threads,
                           const std::function<void(double)>& progress);

}  // namespace kushi
