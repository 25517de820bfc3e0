// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <kushi/distance_field.h>
#include <kushi/mesh.h>
#include <kushi/push_out.h>
#include <kushi/result.h>
#include <kushi/strands.h>
#include <kushi/style.h>

#include <cstddef>
#include <functional>
#include <optional>
#include <string>
#include <vector>

namespace kushi {

/// How to settle; what is left out is as the style says.
struct SettleOptions {
    std::optional<Method> method;
    std::optional<int> segments;       ///< per strand, 1 to 256
    std::optional<std::size_t> count;  ///< strands of all parts together, before cuts leave any out
    int threads = 0;                   ///< 0: as many as the machine has
    bool measurePenetration = false;   ///< fill SettleReport::penetration
    std::string cacheFolder;           ///< of solidsOf()
    const Mesh* head = nullptr;        ///< headOf() the style, if it is at hand already
    /// Told the share done, in [0, 1], now and then and from any thread; may be empty.
    std::function<void(double)> progress;
};

/// A step of the way and how long it took.
struct StageTime {
    std::string stage;
    double milliseconds = 0;
};

/// How the strands of grooms made elsewhere hold the shape that they were set in.
struct SetReport {
    std::size_t unstable = 0;  ///< strands that would not hold it as they are
    std::size_t unheld = 0;    ///< of these, what no stiffening tried has held; they fall
    /// Strands made stiffer so that they hold, and how many times: median and most (1 if none).
    std::size_t stiffened = 0;
    double stiffenedMedian = 1, stiffenedMost = 1;
};

/// How far a part's hair is inside of what it is kept out of: solids, or where there are none its
/// scalp's ellipsoid. Nothing but solids keeps grooms out.
struct PartPenetration {
    std::string part;
    Penetration found;
};

/// How closely hair lies, in voxels of 5 mm.
struct Crowding {
    double packing = 0;  ///< largest share of a voxel that is hair
    double volume = 0;   ///< of the voxels of which 0.1 % or more is hair [m3]
};

struct SettleReport {
    std::size_t strands = 0;
    std::size_t segments = 0;  ///< in all
    std::vector<StageTime> stages;
    /// If measured, of each part that anything keeps out.
    std::vector<PartPenetration> penetration;
    /// Strands that came to rest in solids with a place between their nodes, or walked there, or
    /// lay there in their groom's file, and were turned out of them; and those that are still
    /// nearer than they should be.
    std::size_t pushedOut = 0, stuck = 0;
    std::optional<Crowding> crowding;     ///< if penetration is measured
    std::optional<double> solidsSpacing;  ///< of the solids' distance field [m]
    /// Equilibrium: largest imbalance of moments of any strand over its EI/L + w L^2/2, and how
    /// many strands did not come to rest. The cantilever solves for no rest.
    std::optional<double> maxResidual;
    std::size_t unsettled = 0;
    std::optional<SetReport> set;  ///< where there are grooms
    std::size_t clumps = 0;        ///< that strands lie in
    std::size_t flyaways = 0;      ///< strands that have been bent off
};

/// A head of hair at rest.
struct SettledGroom {
    Strands strands;  ///< as exported: what cuts hide is not in it; with keys,
                      ///< diameters and linear colours
    /// Per strand: the inner end of the short piece that is drawn from the follicle towards the
    /// ellipsoid's centre, so that no gap shows over the head [m]. The follicle itself where there
    /// is none: of grooms that stand 2 cm off the ellipsoid and more.
    std::vector<Vec3f> innerEnds;
    SettleReport report;
};

/// Style -> solids, follicles -> rods -> cuts -> clumps and flyaways. The same style gives the same
/// bytes from any number of threads.
///
/// A count below the style's own keeps an evenly spread subset of its follicles; one above plants
/// anew. Parts share it in proportion to what they have; a groom never has more strands than its
/// file. Where hide cuts leave nothing of a strand (its follicle lies below the height), it is left
/// out. A style whose hair needs the equilibrium method is refused by the cantilever.
///
/// A groom is set as ordinary hair (Hair's defaults, as thick as its file says, or the style if it
/// does not) under the earth's gravity, and rests as it is. Then what the style says otherwise is
/// changed in small steps: gravity, forces, density, stiffness, `set`. Its strands keep their nodes
/// whatever the number of segments asked for, and the colours, diameters and transparencies of
/// their file. What of it lies in solids is turned out before; then it rests against them.
Result<SettledGroom> settle(const Style& style, const SettleOptions& options = {});

/// The strands of a part with a groom, in Kushi's axes. A file that is missing, is no groom, has no
/// strands, or has diameters where the style has a taper is a problem at the place in the style.
Result<Strands> groomOf(const Part& part);

/// What the style's hair is kept out of: its head, if that collides, and its colliders. Empty if
/// there is nothing. Problems are those of readMesh() and distanceFieldOf().
///
/// cacheFolder  where fields are kept, by their contents, and taken from if they are there; it is
///              made if there is none, and no matter if it cannot be written. Empty: nowhere
Result<DistanceField> solidsOf(const Style& style, const std::string& cacheFolder = {},
                               int threads = 0);

/// The style's colliders, without its head. A file that is missing or no mesh is a problem.
Result<std::vector<Mesh>> collidersOf(const Style& style);

/// The head that the style asks for, to draw below its hair; no triangles for "none". A file that
/// is missing or no head is a problem.
Result<Mesh> headOf(const Style& style);

/// The strands with their inner pieces, for drawing.
Strands withInnerPieces(const SettledGroom& groom);

}  // namespace kushi
