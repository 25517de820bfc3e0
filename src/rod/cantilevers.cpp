// SPDX-License-Identifier: Apache-2.0
#include "core/parallel.h"
#include "rod/walk_batch.h"

#include <kushi/cantilevers.h>

#include <cmath>
#include <numbers>

namespace kushi {

namespace {

// Strands that one thread bends together.
constexpr std::size_t batchSize = 512;

std::vector<BoxFace> facesOf(const Box& box) {
    std::vector<BoxFace> faces;
    const Range* ranges[] = {&box.x, &box.y, &box.z};
    for (int axis = 0; axis < 3; ++axis) {
        const Range& range = *ranges[axis];
        if (std::isfinite(range.low)) faces.push_back({axis, 1, static_cast<float>(range.low)});
        if (std::isfinite(range.high)) faces.push_back({axis, -1, static_cast<float>(range.high)});
    }
    return faces;
}

WalkWorld walkWorld(const RodWorld& world, int avoidanceSteps) {
    WalkWorld walk;
    double pull = length(world.gravity);
    for (const Force& force : world.forces)
        pull += std::abs(force.magnitude);
    if (pull > 0) walk.pull = pull;
    walk.gravity = world.gravity / walk.pull;
    for (std::size_t f = 0; f < world.forces.size(); ++f) {
        const Force& force = world.forces[f];
        if (force.magnitude == 0) continue;
        walk.forces.push_back({facesOf(force.within), static_cast<float>(force.falloff.distance),
                               force.direction.radial, force.direction.vector,
                               force.magnitude / walk.pull, f});
    }
    walk.obstacle = world.obstacle;
    walk.solids = world.solids;
    double angle = std::numbers::pi / 2;
    for (int step = 0; step < avoidanceSteps; ++step, angle /= 2) {
        walk.angles.push_back(
            {static_cast<float>(std::cos(angle)), static_cast<float>(std::sin(angle))});
    }
    return walk;
}

}  // namespace

void bendCantilevers(const Rods& rods, const RodWorld& world, std::span<Vec3f> nodes,
                     const WalkOptions& options) {
    const WalkWorld walk = walkWorld(world, options.avoidanceSteps);
    parallelFor(rods.size(), batchSize, options.threads, [&](std::size_t begin, std::size_t end) {
        walkLanes({&rods, &world, &walk, begin, end, nodes});
    });
}

}  // namespace kushi
