// SPDX-License-Identifier: Apache-2.0
#include "head/field.h"
#include "head/shape.h"

#include <array>
#include <numbers>

namespace kushi {

using namespace field;

namespace {

// Outline seen from the side, about the middle of the ear: control radii every 30 degrees from the
// back (0) over the top (90) to the front (180) and the lobe (270), with a neighbour at either end.
constexpr std::array<double, 15> outline = {1.85, 1.75, 2.00, 2.50, 2.95, 2.50, 1.70, 1.30,
                                            1.25, 1.85, 3.25, 2.75, 1.85, 1.75, 2.00};

/// About the distance to the outline, negative inside.
double acrossOutline(double u, double v) {
    const double turn = std::atan2(v, u) / (2 * std::numbers::pi) * 12;
    return std::hypot(u, v) - spline(outline, -1, 1, turn < 0 ? turn + 12 : turn);
}

/// Height of the outer face over the plane of the ear: rim, bowl, ridge round the bowl, tragus.
double relief(Vec3d q, double across) {
    const double angle = std::atan2(q.y, q.x);
    const double fade = ramp(-1.45, -0.7, angle) * (angle > 0 ? ramp(3.1, 2.5, angle) : 1);
    const double rim = (across + 0.30) / 0.24;
    double h = 0.34 * fade * std::exp(-rim * rim);
    const Vec3d flat = {q.x, q.y, 0};
    h -= 0.62 * bump(flat, {-0.35, -0.40, 0}, {1.15, 1.45, 1});
    h -= 0.18 * bump(flat, {-0.1, 1.2, 0}, {1.0, 1.0, 1});
    const double ring = (std::hypot((q.x + 0.3), 0.78 * (q.y + 0.25)) - 0.95) / 0.28;
    h += 0.22 * ramp(-1.9, -0.9, angle) * ramp(2.2, 1.2, angle) * std::exp(-ring * ring);
    h += 0.36 * bump(flat, {-1.15, -0.45, 0}, {0.75, 0.95, 1});
    return h + 0.10 * bump(flat, {-0.1, -2.2, 0}, {1.0, 1.0, 1});
}

double ear(Vec3d q) {
    const double across = acrossOutline(q.x, q.y);
    const double front = q.z - relief(q, across);
    const double back = -0.60 - q.z;
    const double shell = meet(meet(across, front, 0.45), back, 0.5);
    return join(shell, ellipsoid(q, {-0.45, -0.3, -1.0}, {1.3, 1.9, 0.8}),
                0.5);  // back of the bowl
}

}  // namespace

double withEars(Vec3d p, double head) {
    const Vec3d d = Vec3d{p.x, p.y, std::abs(p.z)} - Vec3d{-1.75, -1.1, 7.18};
    if (dot(d, d) > 18) return head;
    // Tipped back, turned out from the side of the head, the lobe close to it.
    const Vec3d tipped = turnedAboutZ(d, radians(-10));
    const Vec3d turned = turnedAboutY(tipped, radians(-17));
    return join(head, ear({-1.06 * turned.x, turned.y, turned.z - 0.13 * turned.y}), 0.7);
}

}  // namespace kushi
