// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <kushi/rods.h>

#include <cstdint>
#include <span>

namespace kushi {

/// Strands of as many segments each, to be settled by one thread.
struct StrandBatch {
    const Rods* rods = nullptr;
    const RodWorld* world = nullptr;
    std::span<const std::uint32_t> strands;
    /// For each strand, per node but the clamp: 3 floats of tangent, or 4 of frame with d3 along
    /// it where there is natural curvature.
    std::span<float> turns;
    bool warm = false;
    double tolerance = 1e-5;

    std::span<Vec3f> nodes;          ///< of all rods
    std::span<float> residuals;      ///< of all rods
    std::span<std::uint8_t> states;  ///< of all rods: 1 settled, 0 not
};

/// Floats that the turns of a strand take.
inline std::size_t turnsPerNode(const Rods& rods) {
    return rods.naturalCurvature.empty() ? 3 : 4;
}

/// Settles a batch with as many strands side by side as the processor has lanes, in float.
void settleLanes(const StrandBatch& batch);

/// Settles one strand in double precision, in many small steps of the load.
void settleReference(const StrandBatch& batch);

/// Width of the skin over a collider in which hair is held: about what other hair takes up [m].
inline constexpr double contactSkin = 2e-3;

/// Depth inside a collider from which a node does not count as held [m].
inline constexpr double contactDepth = 5e-6;

}  // namespace kushi
