// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <span>
#include <vector>

#include <kushi/color.h>
#include <kushi/mesh.h>
#include <kushi/strands.h>

namespace kushi {

/// A distant light.
struct Light {
    Vec3f direction;  ///< unit, from the scene towards the light
    Rgb color;        ///< linear intensity
};

struct Lights {
    Rgb ambient = {1, 1, 1};
    std::vector<Light> distant;
};

/// How hair answers light in the paper's shading (ambient + diffuse + Blinn's specular on a
/// cylinder; Anjyo, Usami & Kurihara 1992).
struct HairLook {
    Rgb color = {0.10F, 0.055F, 0.035F};   ///< diffuse colour
    Rgb specularColor = {1, 1, 1};
    float ambient = 0.15F;    ///< ka
    float diffuse = 0.5F;     ///< kd
    float specular = 0.5F;    ///< ks
    float shininess = 80;     ///< Blinn's exponent n, > 0
};

/// One linear colour per node, seen from `eye` [m].
///
/// The normal at each node is the one of the cylinder that gives the strongest highlight, so that
/// S = (1 - (t.H)^2)^(n/2) and D = sqrt(1 - (t.L)^2), with t the mean direction of the segments that
/// meet at the node. Neither the order of a strand's nodes nor the number of threads matters.
///
/// colors  as many as strands.nodes; overwritten
void shade(const Strands& strands, const Lights& lights, const HairLook& look, Vec3f eye,
           std::span<Rgb> colors, int threads = 0);

/// One linear colour per vertex of a matt mesh: ambient + Lambert.
std::vector<Rgb> shadeMatt(const Mesh& mesh, const Lights& lights, Rgb albedo);

}  // namespace kushi
