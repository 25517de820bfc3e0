// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <kushi/color.h>
#include <kushi/ellipsoid.h>
#include <kushi/fibre.h>
#include <kushi/mesh.h>
#include <kushi/node_colors.h>
#include <kushi/strands.h>

#include <optional>
#include <span>
#include <vector>

namespace kushi {

class Shadows;

/// A distant light.
struct Light {
    Vec3f direction;  ///< unit, from the scene towards the light
    Rgb color;        ///< linear intensity: a white matt surface square to it gets this colour
    float halfAngle = 0.07F;  ///< rad, in (0, pi/2]: the radius of the disc that it is in the sky,
                              ///< for the path tracer's soft shadows; shade() takes it for a point
};

struct Lights {
    Rgb ambient;  ///< linear intensity from everywhere
    std::vector<Light> distant;
};

/// A salon in daylight: a soft key light from the front and above, a little to the person's right;
/// a cool fill from the left; a rim from behind. In world axes, for a head that looks along +x.
Lights studioLights();

/// The same lights as photographers set them, farther apart in strength: for hair that casts
/// shadows.
Lights portraitLights();

/// How hair answers light in the paper's shading (ambient + diffuse + Blinn's specular on a
/// cylinder; Anjyo, Usami & Kurihara 1992).
struct HairLook {
    Rgb color = {0.11F, 0.057F, 0.034F};  ///< of the hair itself: dark brown
    Rgb specularColor = {1.0F, 0.85F, 0.70F};
    float ambient = 0.5F;    ///< ka
    float diffuse = 0.75F;   ///< kd
    float specular = 0.45F;  ///< ks
    float shininess = 160;   ///< Blinn's exponent n, > 0; the highlight is as wide as Kajiya and
                             ///< Kay's with the exponent n / 4
    /// Beyond the paper: what the hair covers. Hair on the side of it that is turned away from a
    /// light gets none of that light; without it nothing casts a shadow.
    std::optional<Ellipsoid> body = std::nullopt;
};

/// One linear colour per node, seen from `eye` [m]:
///
///     ka ambient color  +  sum over lights of  light (kd color D + ks specularColor S),
///     D = sqrt(1 - (t.L)^2),  S = (1 - (t.H)^2)^(n/2),  H = (L + V) / |L + V|.
///
/// That is Blinn's highlight for the brightest normal of the cylinder. t is the mean direction of
/// the segments that meet at the node (one without length counts as its neighbours do), L points to
/// the light, V to the eye; S = 0 for light straight from behind, |L + V| < 1e-4. With a body each
/// light is also multiplied by smoothstep(-0.5, 0.4, N.L), N the body's outward normal at the node.
/// Neither the order of a strand's nodes nor the number of threads matters.
///
/// strands  where they have colours, these replace look.color
/// colors   as many as strands.nodes; overwritten
/// threads  0: as many as the machine has
void shade(const Strands& strands, const Lights& lights, const HairLook& look, Vec3f eye,
           std::span<Rgb> colors, int threads = 0);

/// The same for those nodes that are asked for. The strands must outlive it.
NodeColors nodeColors(const Strands& strands, const Lights& lights, const HairLook& look,
                      Vec3f eye);

/// Hair as fibres of tinted glass, in the light that other hair leaves them and passes on.
struct FibreLook {
    Rgb color = {0.11F, 0.057F, 0.034F};  ///< of a whole head of such hair; of strands without own
    Fibre fibre = {.longitudinal = 0.17, .azimuthal = 0.3};
    float tiltVariation = 0.026F;  ///< rad, by up to which the tilt of a strand's scales differs;
                                   ///< makes the edges of highlights ragged
};

/// One linear colour per node, seen from `eye` [m], by dual scattering (Zinke, Yuksel, Weber &
/// Keyser 2008) with the fibres of kushi/fibre.h seen from afar: light that meets no other fibre
/// first, light that comes through n others, n being Poisson distributed about the crossings that
/// `shadows` knows, and what the hair close by sends back of both. Light from everywhere is taken
/// as the mean over directions. Shadows make it dark beneath and between; what colour light has in
/// the depth is that of the fibres it went through.
///
/// strands  where they have colours, these replace look.color
/// shadows  of the same lights
/// colors   as many as strands.nodes; overwritten
/// threads  0: as many as the machine has; the same colours from any number
void shade(const Strands& strands, const Lights& lights, const Shadows& shadows,
           const FibreLook& look, Vec3f eye, std::span<Rgb> colors, int threads = 0);

/// The same for those nodes that are asked for. Strands and shadows must outlive it.
NodeColors nodeColors(const Strands& strands, const Lights& lights, const Shadows& shadows,
                      const FibreLook& look, Vec3f eye);

/// One linear colour per vertex of a matt mesh: albedo (ambient + sum of light max(0, N.L)).
std::vector<Rgb> shadeMatt(const Mesh& mesh, const Lights& lights, Rgb albedo);

/// The same with an albedo for each vertex.
std::vector<Rgb> shadeMatt(const Mesh& mesh, const Lights& lights, std::span<const Rgb> albedo);

/// The same in the shadow of the mesh itself and of the hair on it.
///
/// shadows  of the same lights
std::vector<Rgb> shadeMatt(const Mesh& mesh, const Lights& lights, std::span<const Rgb> albedo,
                           const Shadows& shadows);

/// Beyond the paper: the albedo of each vertex of a head whose skin takes the colour of the hair
/// that grows there, as skin between hairs looks from afar. Where roots stand as densely as is
/// usual on this head it is 0.6 times the mean colour of the roots within 0.8 cm of the vertex's
/// place on the scalp; towards the hairline it turns smoothly into bare skin, and with less than 8
/// roots a square centimetre, as in previews, more of that shows everywhere.
///
/// strands  root first, with colours; without any the head is bare
/// scalp    the surface on which the roots lie, skin more than 3 cm off it stays bare. None where
/// roots lie on the head itself skin     linear albedo threads  0: as many as the machine has; the
/// same colours from any number
std::vector<Rgb> scalpTint(const Mesh& head, const Strands& strands,
                           const std::optional<Ellipsoid>& scalp, Rgb skin, int threads = 0);

}  // namespace kushi
