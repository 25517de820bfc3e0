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
    std::span<float> turns;  ///< turnsSize() of them, at turnIndex()
    bool warm = false;
    std::span<History> histories;  ///< of all rods
    double tolerance = 1e-5;

    std::span<const std::uint32_t> firstTies;  ///< of each rod in the world's; one more than rods,
                                               ///< or none if there are no ties
    std::span<Vec3f> tieForces;                ///< of all ties [N]; begun from, then overwritten

    std::span<Vec3f> nodes;          ///< of all rods
    std::span<float> residuals;      ///< of all rods
    std::span<std::uint8_t> states;  ///< of all rods: 1 settled, 0 not
};

/// How a node but the clamp is turned: 3 floats of tangent, or 4 of frame with d3 along it where
/// there is natural curvature.
inline std::size_t turnsPerNode(const Rods& rods) {
    return rods.naturalCurvature.empty() ? 3 : 4;
}

/// Strands whose turns lie side by side: as many as the widest registers have lanes.
inline constexpr std::size_t turnsAbreast = 16;

/// Floats for the turns of `count` strands.
inline std::size_t turnsSize(std::size_t count, std::size_t segments, std::size_t perNode) {
    return (count + turnsAbreast - 1) / turnsAbreast * turnsAbreast * segments * perNode;
}

/// Of number `which` of a node (>= 1) of the strand at a place in the batch.
inline std::size_t turnIndex(std::size_t place, std::size_t segments, std::size_t perNode,
                             std::size_t node, std::size_t which) {
    const std::size_t tile = place / turnsAbreast;
    return ((tile * segments + node - 1) * perNode + which) * turnsAbreast + place % turnsAbreast;
}

/// Settles a batch with as many strands side by side as the processor has lanes, in float.
void settleLanes(const StrandBatch& batch);

/// Settles those of a batch that are not settled, one by one, in double precision and with many
/// small steps of the load.
void settleReference(const StrandBatch& batch);

/// Width of the skin over a collider in which hair is held: about what other hair takes up [m].
inline constexpr double contactSkin = 2e-3;

/// Places along a segment at which it may lie on something, at most.
inline constexpr int mostTouchPlaces = 8;

/// Of a tie's spring at first, over what bends and pulls the strand; it holds by its force in the
/// end.
inline constexpr double tieStiffness = 10;

/// How far from its point a tied node may lie [m].
inline constexpr double tieGap = 1e-5;

/// Depth inside a collider from which a node does not count as held [m].
inline constexpr double contactDepth = 5e-6;

}  // namespace kushi
