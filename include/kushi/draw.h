// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <span>

#include <kushi/camera.h>
#include <kushi/image.h>
#include <kushi/mesh.h>
#include <kushi/strands.h>

namespace kushi {

struct DrawOptions {
    int width = 1024, height = 1024;     ///< pixels, 1 to 16384
    int supersample = 4;                 ///< samples per pixel along each axis: 1, 2 or 4
    Rgb background = {0.72F, 0.73F, 0.75F};
    int threads = 0;                     ///< 0: as many as the machine has
};

/// Draws strands as lines one sample wide, with a colour per node interpolated along each segment,
/// and the mesh's triangles with their vertex colours, all depth-tested sample by sample; then
/// averages each pixel's samples in linear light. (The paper: 4096 x 4096 filtered to 1024 x 1024.)
///
/// The result does not depend on the number of threads. Where strands meet at equal depth, the one
/// that comes first wins.
///
/// colors  linear, as many as strands.nodes
/// head    with `colors`; may have no triangles
Image draw(const Strands& strands, std::span<const Rgb> colors, const Mesh& head,
           const Camera& camera, const DrawOptions& options);

}  // namespace kushi
