// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <kushi/camera.h>
#include <kushi/image.h>
#include <kushi/layered_image.h>
#include <kushi/mesh.h>
#include <kushi/node_colors.h>
#include <kushi/strands.h>

#include <cstddef>
#include <cstdint>
#include <span>

namespace kushi {

/// How wide strands are drawn.
enum class Stroke {
    Line,      ///< one sample, whatever the distance: the paper's
    Sampled,   ///< Strands::diameters in perspective, by the samples covered
    Analytic,  ///< the same by the exact area of each pixel covered: softer, and three times as
               ///< slow
};

struct DrawOptions {
    int width = 1024, height = 1024;  ///< pixels, 1 to 16384
    int supersample = 4;              ///< samples per pixel along each axis: 1, 2 or 4
    Rgb background = {0.72F, 0.73F, 0.75F};
    int threads = 0;  ///< 0: as many as the machine has
    Stroke stroke = Stroke::Line;
    /// Times the diameter, for strokes that have one: k where only every k-th strand is drawn, so
    /// that as much stays covered. In (0, 1e6].
    float widen = 1;
    /// Strands wider than two pixels are brighter in their middle than at their edges, and as
    /// bright on average.
    bool round = false;
};

/// Draws strands with a colour per node interpolated along each segment, and the mesh's triangles
/// with their vertex colours, all depth-tested sample by sample; then averages each pixel's samples
/// in linear light. (The paper: lines, 4096 x 4096 filtered to 1024 x 1024.)
///
/// A segment of length l and width w on the picture covers l w samples on average, whatever its
/// place and slope, be w above or below one. Widths run linearly between nodes; a strand without
/// diameters is 75 micrometres wide (usualDiameter), one that is not finite or below zero has none.
/// Analytic strokes are blended from near to far, segment by segment, as if what they cover of a
/// pixel were spread over it; `supersample` is then for the mesh alone.
///
/// Shared nodes are drawn once: a segment owns its first node, not its last. The result does not
/// depend on the number of threads. At equal depth the strand, then the segment, that comes first
/// wins, and hair wins over the mesh. Segments and triangles with a corner that is not finite or
/// lies more than 2^30 samples from the picture are left out.
///
/// colors   linear, as many as strands.nodes
/// head     with `colors`, or it is mid-grey; both sides are drawn; may have no triangles
/// returns  an empty image if an option is out of range or a size does not fit
Image draw(const Strands& strands, std::span<const Rgb> colors, const Mesh& head,
           const Camera& camera, const DrawOptions& options);

/// The same with colours made tile by tile, for the nodes that the picture turns out to show.
Image draw(const Strands& strands, const NodeColors& colors, const Mesh& head, const Camera& camera,
           const DrawOptions& options);

/// Which layers to make.
struct Layers {
    bool depth = false, tangent = false, strand = false, mask = false;
};

/// What draw() draws, without its background, and the layers wanted. With analytic strokes, image,
/// alpha and mask are analytic; the other layers come from samples, drawn beside it.
///
/// Parameters as for draw(); options.background does not count.
LayeredImage drawLayers(const Strands& strands, std::span<const Rgb> colors, const Mesh& head,
                        const Camera& camera, const DrawOptions& options, const Layers& wanted);
LayeredImage drawLayers(const Strands& strands, const NodeColors& colors, const Mesh& head,
                        const Camera& camera, const DrawOptions& options, const Layers& wanted);

/// How much of a surface hair leaves to be seen, in samples of the picture.
struct Showing {
    std::size_t seen = 0;  ///< samples that show it through the hair
    std::size_t bare = 0;  ///< samples that would show it without hair

    /// seen / bare, in [0, 1]; 0 where it cannot be seen anyway.
    double share() const {
        return bare > 0 ? static_cast<double>(seen) / static_cast<double>(bare) : 0;
    }
};

/// Counts the samples of the picture draw() would make that show marked triangles of the head: with
/// the paper's words, whether the scalp shows. Analytic strokes count as Sampled.
///
/// marked   one per triangle of `head`, not 0 where the triangle counts; the others only hide
/// returns  nothing seen if an option is out of range or a size does not fit
Showing countShowing(const Strands& strands, const Mesh& head, std::span<const std::uint8_t> marked,
                     const Camera& camera, const DrawOptions& options);

}  // namespace kushi
