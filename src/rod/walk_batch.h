// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <kushi/rods.h>

#include <span>
#include <vector>

namespace kushi {

/// A face of a force's box: its inner side is where `side` (1 or -1) times the coordinate less
/// `place` is positive [m].
struct BoxFace {
    int axis = 0;
    float side = 1;
    float place = 0;
};

/// A force as the walk wants it.
struct WalkForce {
    std::vector<BoxFace> faces;  ///< those that are anywhere
    float width = 0;             ///< of the ramp across them [m]; 0: a hard step
    bool radial = false;
    Vec3d direction;        ///< not used if radial
    double magnitude = 0;   ///< over WalkWorld::pull
    std::size_t index = 0;  ///< among the world's
};

/// Angles that avoidance turns by: 90, 45, ... degrees.
struct AvoidanceAngle {
    float cosine = 0, sine = 1;
};

/// What acts on all strands of a walk.
struct WalkWorld {
    double pull = 1;  ///< at least as much as all loads together, in the hair's own weight
    Vec3d gravity;    ///< over `pull`, so that no load is large
    std::vector<WalkForce> forces;
    const Ellipsoid* obstacle = nullptr;
    const DistanceField* solids = nullptr;
    std::vector<AvoidanceAngle> angles;
};

/// Strands [begin, end) of some rods, to be bent by one thread.
struct WalkBatch {
    const Rods* rods = nullptr;
    const RodWorld* world = nullptr;
    const WalkWorld* walk = nullptr;
    std::size_t begin = 0, end = 0;
    std::span<Vec3f> nodes;  ///< of all rods
};

/// Bends a batch with as many strands side by side as the processor has lanes, in float.
void walkLanes(const WalkBatch& batch);

}  // namespace kushi
