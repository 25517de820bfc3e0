// SPDX-License-Identifier: Apache-2.0
#include "pipeline/hair_color.h"

#include "core/random.h"
#include "core/smooth_step.h"
#include "pipeline/patch.h"
#include "style/ranges.h"

#include <kushi/strands.h>

#include <algorithm>

namespace kushi {

namespace {

constexpr std::uint64_t lightnessSalt = 0x6c69676874;
constexpr std::uint64_t greySalt = 0x67726579;
constexpr std::uint64_t blendSalt = 0x626c656e64;
constexpr std::uint64_t highlightSalt = 0x686967686c;
constexpr std::uint64_t foilSalt = 0x666f696c;
constexpr float rootDarkness = 0.35F;
constexpr float rootLength = 0.03F;  // m
// Strands fade earlier or later by up to this share of the blend.
constexpr double raggedness = 0.25;

// 0 below, 1 above.
double ramp(double low, double high, double value) {
    if (low < high) return smoothStep(low, high, value);
    return value < high ? 0 : 1;
}

// Of the end's colour, so far from that end.
double share(const EndColor& end, double away, double ragged) {
    return 1 - ramp(end.length - end.blend, end.length, away + ragged * end.blend);
}

double share(const Highlight& highlight, double away, double ragged) {
    const double half = highlight.blend / 2;
    const double at = away + ragged * highlight.blend;
    const double begun =
        highlight.from > 0 ? ramp(highlight.from - half, highlight.from + half, at) : 1;
    return begun * (1 - ramp(highlight.to - half, highlight.to + half, at));
}

bool has(const Highlight& highlight, std::size_t which, std::uint64_t key, EllipsoidAngles angles,
         Vec3d root) {
    if (!contains(highlight.roots, angles)) return false;
    const std::uint64_t drawn =
        highlight.foil > 0 ? patchOf(root, highlight.foil, mixKey(foilSalt, which)) : key;
    return uniform(mixKey(drawn, mixKey(highlightSalt, which))) < highlight.share;
}

}  // namespace

void appendHairColors(const Part& part, std::uint64_t key, EllipsoidAngles angles,
                      std::span<const Vec3f> nodes, std::vector<Rgb>& colors) {
    const Hair& hair = part.hair;
    const auto lightness =
        static_cast<float>(1 + hair.variation * uniformSigned(mixKey(key, lightnessSalt)));
    const double ragged = raggedness * uniformSigned(mixKey(key, blendSalt));
    const bool grey = uniform(mixKey(key, greySalt)) < hair.grey.share;
    std::vector<const Highlight*> highlights;
    for (std::size_t i = 0; i < part.highlights.size(); ++i) {
        if (has(part.highlights[i], i, key, angles, nodes[0].as<double>()))
            highlights.push_back(&part.highlights[i]);
    }
    const double whole = hair.tips ? polylineLength(nodes) : 0;
    float walked = 0;
    for (std::size_t i = 0; i < nodes.size(); ++i) {
        if (i > 0) walked += length(nodes[i] - nodes[i - 1]);
        const auto away = static_cast<double>(walked);
        Rgb own = grey ? hair.grey.color : hair.color;
        if (hair.tips) own = mixed(own, hair.tips->color, share(*hair.tips, whole - away, ragged));
        for (const Highlight* highlight : highlights)
            own = mixed(own, highlight->color, share(*highlight, away, ragged));
        if (hair.regrowth)
            own = mixed(own, hair.regrowth->color, share(*hair.regrowth, away, ragged));
        const float nearRoot = 1 - std::min(1.0F, walked / rootLength);
        colors.push_back((1 - rootDarkness * nearRoot * nearRoot) * (lightness * own));
    }
}

}  // namespace kushi
