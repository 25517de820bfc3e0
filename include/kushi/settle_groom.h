// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <kushi/settle.h>

namespace kushi {

/// How to settle a groom made elsewhere. It is taken to rest as it is, of `hair` (each strand as
/// thick as the groom says, if it does) under `setGravity`; then the rest is changed.
struct GroomSettleOptions {
    Hair hair;
    Vec3d setGravity = {0, -1, 0};  ///< times the earth's
    Vec3d gravity = {0, -1, 0};     ///< that it is then under, times the earth's
    double weightScale = 1;         ///< > 0; wet hair is about 1.3 times as heavy
    double stiffnessScale = 1;      ///< > 0; of EI and GJ, the natural shape stays
    /// Share of the natural shape that stays, in [0, 1], and of what holds it; 0: straight hair.
    double set = 1;
    const DistanceField* solids = nullptr;  ///< kept outside of; none if null
    std::span<const float> frictions = {};  ///< of the solids; empty: none
    int threads = 0;                        ///< 0: as many as the machine has
    /// Told the share done, in [0, 1], now and then; may be empty.
    std::function<void(double)> progress;
};

struct GroomSettleReport {
    std::size_t strands = 0;
    std::size_t segments = 0;  ///< in all
    std::vector<StageTime> stages;
    double maxResidual = 0;     ///< of the strands that settled, over EI/L + w L^2/2
    std::size_t unsettled = 0;  ///< strands that did not come to rest
    SetReport set;
    /// With solids: strands that lay in them and were turned out; those that are still nearer than
    /// they should be; and how far hair is inside in the end.
    std::size_t pushedOut = 0, stuck = 0;
    std::optional<Penetration> penetration;
};

struct SettledStrands {
    Strands strands;  ///< the groom with nodes at rest; what else it has is as it was
    GroomSettleReport report;
};

/// Sets a groom and brings it to rest under what has changed. The change is made in small steps
/// from the groom as it is, and each strand takes the rest that this leads to; where nothing has
/// changed, nodes stay within 1e-4 of the strand's length.
///
/// What lies in solids, or nearer to them than pushOut() allows, is turned out first, and set
/// there; then strands rest against the solids, from where they come out of them by their roots.
/// Other hair is in nobody's way.
///
/// The same groom gives the same nodes from any number of threads.
Result<SettledStrands> settleGroom(const Strands& groom, const GroomSettleOptions& options = {});

}  // namespace kushi
