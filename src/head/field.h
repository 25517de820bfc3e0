// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <kushi/vec.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>

// Implicit shapes in centimetres: negative inside, about the distance to the surface near it.
namespace kushi::field {

/// First-order distance to an ellipsoid: exact in the limit of the surface.
inline double ellipsoid(Vec3d p, Vec3d center, Vec3d radii) {
    const Vec3d d = p - center;
    const Vec3d scaled = {d.x / radii.x, d.y / radii.y, d.z / radii.z};
    const Vec3d twice = {scaled.x / radii.x, scaled.y / radii.y, scaled.z / radii.z};
    const double k = length(scaled);
    return k * (k - 1) / std::max(length(twice), 1e-9);
}

/// A stretch of tube from `a` to `b` whose radius changes evenly from ra to rb.
inline double tube(Vec3d p, Vec3d a, Vec3d b, double ra, double rb) {
    const Vec3d axis = b - a;
    const double t = std::clamp(dot(p - a, axis) / dot(axis, axis), 0.0, 1.0);
    return length(p - a - t * axis) - (ra + t * (rb - ra));
}

/// Union with a fillet of width k; twice continuously differentiable, adds at most k / 6.
inline double join(double a, double b, double k) {
    const double h = std::max(k - std::abs(a - b), 0.0) / k;
    return std::min(a, b) - h * h * h * k / 6;
}

/// Intersection with a rounded edge of width k.
inline double meet(double a, double b, double k) {
    return -join(-a, -b, k);
}

/// `a` without `b`, with a rounded edge of width k.
inline double carve(double a, double b, double k) {
    return meet(a, -b, k);
}

/// 1 at the centre of an ellipsoidal neighbourhood, falling smoothly to 0 at its border.
inline double bump(Vec3d p, Vec3d center, Vec3d radii) {
    const Vec3d d = p - center;
    const Vec3d scaled = {d.x / radii.x, d.y / radii.y, d.z / radii.z};
    const double rest = std::max(1 - dot(scaled, scaled), 0.0);
    return rest * rest * rest;
}

/// 0 below `low`, 1 above `high`, smooth between.
inline double ramp(double low, double high, double x) {
    const double t = std::clamp((x - low) / (high - low), 0.0, 1.0);
    return t * t * t * (t * (6 * t - 15) + 10);
}

/// Uniform cubic B-spline with the control values at first, first + step, ...; constant beyond.
template <std::size_t n>
double spline(const std::array<double, n>& values, double first, double step, double x) {
    const double at = std::clamp((x - first) / step, 1.0, static_cast<double>(n) - 2.001);
    const auto i = static_cast<std::size_t>(at);
    const double t = at - static_cast<double>(i);
    const double s = 1 - t;
    return (s * s * s * values[i - 1] + (4 - 6 * t * t + 3 * t * t * t) * values[i] +
            (4 - 6 * s * s + 3 * s * s * s) * values[i + 1] + t * t * t * values[i + 2]) /
           6;
}

/// `v` turned by `angle` about z, from x towards y.
inline Vec3d turnedAboutZ(Vec3d v, double angle) {
    const double c = std::cos(angle);
    const double s = std::sin(angle);
    return {c * v.x - s * v.y, s * v.x + c * v.y, v.z};
}

/// `v` turned by `angle` about y, from z towards x.
inline Vec3d turnedAboutY(Vec3d v, double angle) {
    const double c = std::cos(angle);
    const double s = std::sin(angle);
    return {c * v.x + s * v.z, v.y, c * v.z - s * v.x};
}

}  // namespace kushi::field
