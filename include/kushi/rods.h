// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <kushi/distance_field.h>
#include <kushi/style.h>
#include <kushi/vec.h>

#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

namespace kushi {

/// A rotation of a strand's own axes (d1 and d2 across it, d3 along it) into the world's: a unit
/// quaternion.
struct Frame {
    float w = 1, x = 0, y = 0, z = 0;
};

/// The frame that turns d3 into `direction` (unit) by the shortest way.
Frame frameAlong(Vec3d direction);

/// Where a frame turns d3: a unit vector.
Vec3d directionOf(const Frame& frame);

/// Strands as inextensible Kirchhoff rods, clamped at their roots. What is per strand has size()
/// entries; what is per segment is empty or has offsets.back(). A strand may have no segments: it
/// is its root, and its lengths, bending, ... do not count.
struct Rods {
    std::vector<Vec3f> roots;                  ///< m
    std::vector<Frame> clamps;                 ///< of the root
    std::vector<float> lengths;                ///< m, > 0
    std::vector<float> bending;                ///< EI at the root [N m2], > 0
    std::vector<float> twisting;               ///< GJ at the root [N m2], > 0
    std::vector<float> weights;                ///< per unit length at the root, g = 9.80665 [N/m]
    std::vector<std::uint64_t> keys;           ///< what an upright strand falls by
    std::vector<std::uint32_t> offsets = {0};  ///< of strand i's segments; size() + 1 of them

    std::vector<float> segmentLengths;  ///< m; empty: equal. Those of a strand add up to its length
    std::vector<Vec3f> naturalCurvature;  ///< about d1, d2 and d3 (twist) [1/m]; empty: straight
    std::vector<float> thickness;         ///< radius over that at the root: EI and GJ go with its
                                          ///< fourth power, weight with its second; empty: 1
    std::vector<Vec3f> chords;  ///< from node to node in the frame midway, with natural curvature
                                ///< only [m]; empty: those of helices
    std::vector<Frame> starts;  ///< of each segment's far node: where a cold solve begins, with all
                                ///< of the loads; empty: at the natural shape, with few of them

    std::size_t size() const { return roots.size(); }
    std::size_t segments(std::size_t strand) const { return offsets[strand + 1] - offsets[strand]; }
    double segmentLength(std::size_t strand, std::size_t segment) const {
        return segmentLengths.empty() ? lengths[strand] / static_cast<double>(segments(strand))
                                      : segmentLengths[offsets[strand] + segment];
    }
    /// Where strand i's nodes begin in an array of all nodes, root first.
    std::size_t firstNode(std::size_t strand) const { return offsets[strand] + strand; }
    std::size_t nodeCount() const { return offsets.back() + size(); }
};

/// A node that is held at a point, as by a band around many hairs. It may turn there.
struct Tie {
    static constexpr std::uint32_t none = 0xffffffff;

    std::uint32_t strand = 0;
    std::uint32_t node = 0;     ///< of the strand, >= 1
    Vec3f point;                ///< m
    std::uint32_t knot = none;  ///< ties of one knot are held at the same point, which comes to
                                ///< rest with the strands: looked for near the mean of `point`
};

/// Hair that lies on other hair: what it rests on is taken to be thicker by `slope` times the way
/// from the root, up to the way `reach`.
struct Layer {
    float slope = 0;  ///< < 0: thinner, for hair that lies nearer than what would push it
    float reach = 0;  ///< m, >= 0
};

/// What acts on rods.
struct RodWorld {
    Vec3d gravity = {0, -1, 0};  ///< times the earth's
    /// Their `within` and `falloff.distance` count; a segment feels what acts at its middle. Edges
    /// fall off over at least a segment: at a hard one there need not be any rest.
    std::span<const Force> forces = {};
    std::span<const float> rootShares = {};  ///< of each strand in each force, strand by strand
    const Ellipsoid* obstacle = nullptr;     ///< kept outside of; none if null
    const DistanceField* solids = nullptr;   ///< kept outside of as well; none if null
    /// Coulomb's coefficients, of the obstacle and of each of the solids: hair stays where it came
    /// to lie while what pulls it along the surface is less than so much of what presses it on.
    float obstacleFriction = 0;
    std::span<const float> solidFrictions = {};  ///< empty: none
    std::span<const Layer> layers = {};          ///< of each strand; empty: all lie on the skin
    /// Of each segment of all rods, at its middle, times its weight: what stays the same wherever
    /// the segment goes, as what leads it to where other hair leaves it room. Empty: none.
    std::span<const Vec3f> loads = {};
    /// In the order of their strands. One that lies farther from the root than the hair between
    /// can reach leaves its strand unsettled.
    std::span<const Tie> ties = {};
};

/// How warm solves of a strand go.
enum class History : std::uint8_t {
    Other,    ///< from where it was
    Hung,     ///< as hair that only hangs
    Renewed,  ///< anew, as one of them has done before
};

/// How the last settling ended: where the next begins. Only settleRods() knows what is in it.
struct RestState {
    std::vector<float> turns;
    std::vector<History> histories;
    std::vector<Vec3f> tieForces;
    std::uint64_t layout = 0;
};

/// Where the last settling left the segments' far nodes, for Rods::starts; `state` is of these
/// rods, which have natural curvature.
std::vector<Frame> framesAtRest(const Rods& rods, const RestState& state);

struct RestOptions {
    double tolerance = 1e-5;  ///< largest imbalance of moments over EI/L + w L^2/2, per strand
    bool warm = false;        ///< begin at the state, if it is of the same rods
    int threads = 0;          ///< 0: as many as the machine has
    bool refine = true;       ///< what does not come to rest in floats is tried in doubles
};

struct RestReport {
    std::vector<float> residuals;          ///< of each strand, over EI/L + w L^2/2
    std::vector<std::uint32_t> unsettled;  ///< strands that did not come to rest
    std::size_t refined = 0;               ///< strands that needed double precision
    std::vector<Vec3f> tieForces;          ///< of each tie on its strand [N]
};

/// Brings rods to static rest: elastic, gravity, force and contact moments balance at every node.
///
/// Each segment bends and twists between the frames of its two nodes and has a chord of fixed
/// length, so length is kept exactly; its weight acts at its middle. Where there are several
/// rests, a strand takes the one reached from its natural shape as the loads grow from zero, or the
/// one near `starts`; one that stands upright falls to a side that its key chooses. The ellipsoid
/// pushes from two millimetres above its surface, so that no node reaches it. Ties hold their nodes
/// to a hundredth of a millimetre. docs/physics.md has it all.
///
/// Straight rods without natural curvature do not twist and take a cheaper way.
///
/// nodes   rods.nodeCount() of them; overwritten [m]
/// Results do not depend on the number of threads.
RestReport settleRods(const Rods& rods, const RodWorld& world, RestState& state,
                      std::span<Vec3f> nodes, const RestOptions& options = {});

}  // namespace kushi
