// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <kushi/image.h>
#include <kushi/result.h>
#include <kushi/vec.h>

#include <cstdint>
#include <string>
#include <vector>

namespace kushi {

/// A picture without a background, with what else is known of its pixels, for compositing. Every
/// layer has as many values as the image has pixels, or none if it was not asked for.
struct LayeredImage {
    /// Depth where there is nothing [m].
    static constexpr float nothing = 1e10F;
    /// Strand where there is no hair.
    static constexpr std::uint32_t noStrand = 0xffffffff;

    Image image;               ///< linear light times alpha; add background times (1 - alpha)
    std::vector<float> alpha;  ///< share of the pixel that shows hair or head; always there
    std::vector<float> depth;  ///< m along the view from the camera's plane; of the nearest sample
    /// The mean direction, in world axes and from root to tip, of the hair seen, of length 1. Where
    /// directions cancel, that of the nearest hair; 0 where there is none.
    std::vector<Vec3f> tangent;
    std::vector<std::uint32_t> strand;  ///< index of the one that most samples show; at equality
                                        ///< the nearest
    std::vector<float> mask;            ///< share of the pixel that shows hair
};

/// Writes an OpenEXR file with all layers there are: R, G, B, A (half floats; linear light, sRGB
/// primaries, premultiplied), Z, tangent.X, tangent.Y, tangent.Z, mask.A (floats) and id.strand
/// (unsigned integers). Values are written as they are. The file appears whole or not at all.
///
/// Layers that do not fit the image, or an image without pixels, are a problem.
Status writeExr(const LayeredImage& image, const std::string& path);

/// Writes an 8-bit sRGB PNG with its alpha, which PNG does not multiply in; for the rest as
/// writePng() for images.
Status writePng(const LayeredImage& image, const std::string& path);

}  // namespace kushi
