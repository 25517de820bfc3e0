// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <kushi/camera.h>
#include <kushi/mesh.h>
#include <kushi/strands.h>

#include <vector>

namespace kushi::bench {

/// What the benchmarks draw: a head, its hair, and where from.
struct Wig {
    Strands strands;          ///< about 50,000 strands of 20 segments, 25 cm long
    std::vector<Rgb> colors;  ///< one per node
    Mesh head;                ///< with colours
    Camera camera;            ///< so near that hair covers half of a square picture
};

/// The mannequin under a hanging wig, lit as a studio is.
Wig mannequinWig();

}  // namespace kushi::bench
