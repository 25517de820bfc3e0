// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <kushi/result.h>
#include <kushi/rods.h>
#include <kushi/strands.h>

#include <cstdint>
#include <span>
#include <vector>

namespace kushi {

/// What the strands of a groom are made of; a number for each strand, as in Rods.
struct StrandMaterials {
    std::vector<float> bending;    ///< EI at the root [N m2], > 0
    std::vector<float> twisting;   ///< GJ at the root [N m2], > 0
    std::vector<float> weights;    ///< per unit length at the root [N/m]
    std::vector<float> thickness;  ///< for each node of the groom: radius over that at the root;
                                   ///< or empty: 1
};

/// The materials of a groom of which every strand is of `hair`, but as thick as the groom says if
/// it does: EI goes with the fourth power of the diameter and weight with its second. A diameter is
/// taken for no less than a tenth of the strand's largest, so that a tip that tapers to nothing
/// keeps some stiffness; a strand without any is as thick as `hair`.
StrandMaterials materialsOf(const Strands& groom, const Hair& hair);

struct SetOptions {
    bool stiffen = true;  ///< raise EI and GJ of the strands that would not hold until they do
    int threads = 0;      ///< 0: as many as the machine has
};

/// A groom as rods that rest where it is.
struct SetGroom {
    /// Strand i of the groom is strand i here. One of a single node, or all of whose nodes
    /// coincide, has no segment.
    Rods rods;

    /// The node of `rods` that each node of the groom goes with, and where from there [m]. Nodes
    /// less than a thousandth of the strand's mean segment apart go together.
    std::vector<std::uint32_t> nodes;
    std::vector<Vec3f> offsets;

    /// How many times its EI and GJ each strand needs to hold, with a quarter to spare: 1 for one
    /// that holds as it is, infinite beyond stiffestHold.
    std::vector<float> factors;
    std::vector<std::uint32_t> unstable;  ///< strands that do not hold with what they are made of
    std::vector<std::uint32_t> unheld;    ///< those that would not at stiffestHold either
};

/// The most that is tried to make a strand hold.
inline constexpr double stiffestHold = 1000;

/// The rods whose rest under `world` is exactly the groom ("set", hairspray): inverse statics.
///
/// A strand clamped at its root is statically determinate: where it is, the loads beyond a segment
/// give its moment, and the natural curvature and twist that balance it are a formula, without any
/// iteration (Derouet-Jourdan, Bertails-Descoubes and Thollot, "Stable inverse dynamic curves",
/// 2010, for super-helices). Frames lie along the circles through neighbouring nodes and do not
/// twist along the strand; each segment keeps the groom's chord.
///
/// Whether that rest is a stable one is another question: too heavy a strand topples out of its
/// shape. It is answered for each, by the pivots of the exact Hessian, together with the stiffness
/// that holds it. More stiffness never hurts here: the moments stay what the loads ask for.
///
/// `world` has the shares of forces of every strand of the groom; its obstacle does not count.
/// A strand that stays put does so under these loads; settleRods() begins there.
/// A node that is not finite, or materials that do not fit the groom, are a problem.
/// Results do not depend on the number of threads.
Result<SetGroom> restShapeOf(const Strands& groom, const StrandMaterials& materials,
                             const RodWorld& world, const SetOptions& options = {});

/// The rods with only a share of the set: 1 as it is; 0 straight along the root's tangent, and
/// between them natural curvature and twist in proportion. The same lengths and stiffness.
Rods withStrength(const Rods& set, double strength);

/// The nodes of the groom where those of its rods have been brought.
void placeNodes(const SetGroom& set, std::span<const Vec3f> rodNodes, std::span<Vec3f> nodes);

}  // namespace kushi
