// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <kushi/camera.h>
#include <kushi/fibre.h>
#include <kushi/image.h>
#include <kushi/mesh.h>
#include <kushi/result.h>
#include <kushi/shade.h>
#include <kushi/strands.h>

#include <cstdint>
#include <functional>
#include <span>
#include <vector>

namespace kushi {

/// What hair and skin are made of, for the path tracer.
struct TraceLook {
    Fibre fibre = FibreLook{}.fibre;
    float tiltVariation = FibreLook{}.tiltVariation;  ///< rad, as in FibreLook
    Rgb color =
        FibreLook{}.color;  ///< that a whole head of the hair shows, where strands have none
    float diameter = usualDiameter;  ///< m, where strands have none
    /// Share of light that skin reflects at right angles without tinting it, in [0, 1]; more
    /// where it grazes (Schlick 1994). 0 makes it matt.
    float skinGloss = 0.028F;
    float skinRoughness = 0.45F;  ///< of that: the width of GGX, in [0.05, 1]
};

struct TraceOptions {
    int width = 1024, height = 1024;  ///< pixels, 1 to 16384
    int samplesPerPixel = 64;         ///< 1 to 65536; powers of two serve best
    int bounces = 64;                 ///< how often light is scattered at most, 0 to 10000
    /// A tile of 16 x 16 pixels is done before it has all of its samples when its estimated noise
    /// is less; 0: never. Noise is the root mean square of its pixels' standard errors, as a share
    /// of its mean brightness, in [0, 1].
    float noise = 0;
    /// Light that was scattered more than once brings a sample at most this much in any channel;
    /// 0: whatever it brings. It trades rare bright specks for a little energy.
    float clamp = 16;
    std::uint64_t seed = 0;
    Rgb background = {0.72F, 0.73F, 0.75F};  ///< what the camera sees behind; lights nothing
    int threads = 0;                         ///< 0: as many as the machine has
    /// Called with the share that is done, in [0, 1], from any thread; may be empty.
    std::function<void(double)> progress = {};
};

struct Traced {
    Image image;               ///< linear, over the background
    std::vector<float> alpha;  ///< per pixel: share that hair and head cover, in [0, 1]
    double samples = 0;        ///< per pixel, mean
    double noise = 0;          ///< as TraceOptions::noise, of the whole picture
};

/// Follows light from the camera backwards: every hair a round glass fibre with the scattering of
/// fibreResponse(), the head of matt skin under a thin gloss, under an even sky of the ambient
/// light and the distant lights as discs. Both sides of the head count. Nothing but chance, the
/// limit of bounces and the clamp stand between the mean of many samples and the solution of the
/// rendering equation (Kajiya 1986).
///
/// The same input gives the same bytes from any number of threads.
///
/// strands  colors (what a head of such hair shows) and diameters replace those of `look`;
///          segments that are not finite are left out
/// head     may have no triangles; corners that are not finite are left out
/// skin     albedo, one per vertex of the head, or none for mid-grey; clamped to [0, 1]
/// returns  problems if an option is out of range, a size does not fit or the camera looks nowhere
Result<Traced> trace(const Strands& strands, const Mesh& head, std::span<const Rgb> skin,
                     const Lights& lights, const Camera& camera, const TraceLook& look,
                     const TraceOptions& options);

}  // namespace kushi
