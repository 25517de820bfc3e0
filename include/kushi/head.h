// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <kushi/ellipsoid.h>
#include <kushi/mesh.h>

#include <cstdint>
#include <optional>
#include <span>
#include <string_view>
#include <vector>

namespace kushi {

// The built-in head, its landmarks and where hair grows on it; docs/head.md has the figures.

/// A hairdresser's training head: a calm, abstract face with blank eyes, neck and bust, of adult
/// proportions, placed about headEllipsoid(). Closed, manifold, exactly mirrored in z, some 46,000
/// triangles, no colours; those of scalpTriangles() are the group "scalp". The same bytes at every
/// call; takes about a quarter of a second.
Mesh mannequin();

/// Stands for the mannequin's vertices and triangles: another number whenever they change.
inline constexpr std::uint64_t mannequinKey = 13394650265352126557U;

/// The ellipsoid the mannequin is placed about: it encloses cranium, face and ears, and stands at
/// most 1.5 cm off the skin where hair grows. Centre at the origin, semi-axes 10.5, 12.5 and
/// 8.5 cm, tipped back by 20 degrees.
Ellipsoid headEllipsoid();

/// A height on the mannequin that styles may name.
struct Landmark {
    std::string_view name;
    double y = 0;  ///< m
};

/// crown, hairline, brows, eyes, ears, nose, lips, nape, chin, shoulders: from the top down.
std::span<const Landmark> headLandmarks();

/// Height of a landmark [m]; nothing if there is none of that name.
std::optional<double> landmarkHeight(std::string_view name);

/// Follicles by the angles of headEllipsoid() [rad]; closed. theta lies within [0, pi]; phi may run
/// past pi and spans at most a turn.
struct AngleRange {
    double thetaLow = 0, thetaHigh = 0;
    double phiLow = 0, phiHigh = 0;

    bool contains(EllipsoidAngles angles) const;
};

/// A part of the hair with a name.
struct HairZone {
    std::string_view name;
    std::span<const AngleRange> ranges;  ///< their union
};

/// crown, top, front, fringe, hairline, sides, left, right, back and nape. They overlap.
std::span<const HairZone> hairZones();

/// The ranges of a zone; empty if there is none of that name.
std::span<const AngleRange> hairZone(std::string_view name);

/// Where hair grows: from the hairline over the forehead, by the temples and round the ears to the
/// nape. A good default for the regions of a scalp on headEllipsoid().
std::span<const AngleRange> hairRegion();

/// 1 for every triangle of a head that stands as the mannequin does and from which hair grows: its
/// middle lies in hairRegion() and less than 2 cm off headEllipsoid(). 0 for the others.
std::vector<std::uint8_t> scalpTriangles(const Mesh& head);

}  // namespace kushi
