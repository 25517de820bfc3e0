// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <kushi/vec.h>

#include <cmath>
#include <string_view>

namespace kushi {

/// A number of the style file: its closed range in its own unit, and what it is in SI.
///
/// docs/style-file.md lists these ranges for users.
struct Quantity {
    double low = 0, high = 0;
    std::string_view unit;  ///< as problems name it; empty if none
    double (*toSi)(double) = [](double value) { return value; };

    /// A unit that people write by mistake: how much of `unit` one of it is.
    struct Mistaken {
        std::string_view unit;
        double size = 0;
    };
    Mistaken mistaken[3] = {};
};

namespace quantities {

// Division by a power of ten rounds once, so that 75 micrometres are the double nearest to 75e-6.
inline double fromCentimetres(double value) {
    return value / 100;
}
inline double fromMicrometres(double value) {
    return value / 1e6;
}
inline double fromGigapascals(double value) {
    return value * 1e9;
}
inline double fromGramsPerCubicCentimetre(double value) {
    return value * 1e3;
}

/// The inverse of the sRGB transfer function (IEC 61966-2-1).
inline double fromSrgb(double value) {
    return value <= 0.04045 ? value / 12.92 : std::pow((value + 0.055) / 1.055, 2.4);
}

inline constexpr Quantity gravity = {-100, 100, "times the earth's"};

inline constexpr Quantity place = {-1000, 1000, "cm", fromCentimetres};
/// By which hair stays off a body.
inline constexpr Quantity gap = {-2, 5, "cm", fromCentimetres, {{"mm", 0.1}}};
inline constexpr Quantity friction = {0, 2, "", [](double v) { return v; }, {{"%", 0.01}}};
inline constexpr Quantity packing = {0.001, 0.9, "", [](double v) { return v; }, {{"%", 0.01}}};
/// What one unit of a mesh or strand file is.
inline constexpr Quantity fileUnit = {1e-4, 1e4, "cm", fromCentimetres};
/// Of a tie.
inline constexpr Quantity tieRadius = {0, 10, "cm", fromCentimetres, {{"mm", 0.1}, {"m", 100}}};
inline constexpr Quantity slack = {0.005, 1, "", [](double v) { return v; }, {{"%", 0.01}}};
inline constexpr Quantity semiAxis = {0.5, 100, "cm", fromCentimetres, {{"mm", 0.1}, {"m", 100}}};
inline constexpr Quantity rotation = {-360, 360, "degrees", radians};
inline constexpr Quantity spacing = {0.01, 10, "cm", fromCentimetres, {{"mm", 0.1}, {"m", 100}}};
inline constexpr Quantity jitter = {0, 1, "spacings", [](double v) { return v; }, {{"%", 0.01}}};
inline constexpr Quantity edge = {0, 5, "cm", fromCentimetres, {{"mm", 0.1}}};
inline constexpr Quantity theta = {0, 180, "degrees", radians};
inline constexpr Quantity phi = {-360, 360, "degrees", radians};

inline constexpr Quantity length = {0.1, 300, "cm", fromCentimetres, {{"mm", 0.1}, {"m", 100}}};
inline constexpr Quantity lengthVariation = {0, 0.9, "", [](double v) { return v; }, {{"%", 0.01}}};
inline constexpr Quantity youngsModulus = {
    0.01, 100, "GPa", fromGigapascals, {{"MPa", 1e-3}, {"Pa", 1e-9}}};
inline constexpr Quantity diameter = {
    10, 300, "micrometres", fromMicrometres, {{"mm", 1e3}, {"cm", 1e4}, {"m", 1e6}}};
inline constexpr Quantity density = {
    0.1, 10, "g/cm3", fromGramsPerCubicCentimetre, {{"kg/m3", 1e-3}}};
inline constexpr Quantity flexuralRigidity = {1e-12, 1, "N m2"};
inline constexpr Quantity stiffness = {0.001, 1000, ""};

inline constexpr Quantity taper = {0, 0.95, "", [](double v) { return v; }, {{"%", 0.01}}};
inline constexpr Quantity curlSize = {0.05, 50, "cm", fromCentimetres, {{"mm", 0.1}}};
inline constexpr Quantity grading = {1, 3, ""};

inline constexpr Quantity color = {0, 1, "", fromSrgb, {{"of 255", 1.0 / 255}}};
inline constexpr Quantity set = {0, 1, "", [](double v) { return v; }, {{"%", 0.01}}};
inline constexpr Quantity variation = {0, 1, "", [](double v) { return v; }, {{"%", 0.01}}};

inline constexpr Quantity clump = {0, 0.9, "", [](double v) { return v; }, {{"%", 0.01}}};
inline constexpr Quantity clumpSize = {0.1, 20, "cm", fromCentimetres, {{"mm", 0.1}}};
inline constexpr Quantity clumpFrom = {0, 0.9, "", [](double v) { return v; }, {{"%", 0.01}}};
inline constexpr Quantity flyawayShare = {0, 1, "", [](double v) { return v; }, {{"%", 0.01}}};
inline constexpr Quantity flyawayDistance = {0.05, 20, "cm", fromCentimetres, {{"mm", 0.1}}};

inline constexpr Quantity melanin = {0, 20, ""};
inline constexpr Quantity redness = {0, 1, "", [](double v) { return v; }, {{"%", 0.01}}};
inline constexpr Quantity colorShare = {0, 1, "", [](double v) { return v; }, {{"%", 0.01}}};
/// Along a strand.
inline constexpr Quantity coloredLength = {0.1, 300, "cm", fromCentimetres, {{"mm", 0.1}}};
inline constexpr Quantity colorPlace = {0, 300, "cm", fromCentimetres, {{"mm", 0.1}}};
inline constexpr Quantity foil = {0, 20, "cm", fromCentimetres, {{"mm", 0.1}}};

/// From the surface of the scalp.
inline constexpr Quantity lift = {0, 90, "degrees", radians};
/// Of hair about a whorl.
inline constexpr Quantity turn = {-180, 180, "degrees", radians};
inline constexpr Quantity direction = {-1000, 1000, ""};
inline constexpr Quantity magnitude = {-1000, 1000, "times the hair's own weight"};
inline constexpr Quantity falloffAngle = {0, 180, "degrees", radians};
inline constexpr Quantity falloffDistance = {0, 100, "cm", fromCentimetres};
inline constexpr Quantity lengthLeft = {0, 300, "cm", fromCentimetres};

}  // namespace quantities

}  // namespace kushi
