// SPDX-License-Identifier: Apache-2.0
#include "head/field.h"
#include "head/shape.h"

namespace kushi {

using namespace field;

namespace {

// Horizontal sections of the face, one every 1.5 cm upwards from y = -15.
constexpr double lowest = -15;
constexpr double step = 1.5;
constexpr std::array<double, 18> front = {3.0, 4.2, 5.4, 6.75, 7.75, 7.75, 8.45, 8.45, 8.2,
                                          8.0, 8.0, 8.5, 8.75, 8.4,  7.6,  6.2,  4.0,  2.0};
constexpr std::array<double, 18> halfWidth = {0.5,  0.7,  1.4, 2.9, 4.3, 5.3, 5.85, 6.2, 6.5,
                                              6.75, 6.75, 6.5, 6.3, 5.9, 5.2, 4.2,  3.0, 1.5};
constexpr std::array<double, 18> roundness = {2.0, 2.0, 2.0, 2.0, 2.0, 1.9, 1.8, 1.7, 1.6,
                                              1.5, 1.5, 1.5, 1.5, 1.6, 1.7, 1.9, 2.0, 2.0};

double faceBlock(Vec3d p) {
    constexpr double middle = -0.5;
    const double d = spline(front, lowest, step, p.y) - middle;
    const double w = spline(halfWidth, lowest, step, p.y);
    const double u = std::max(p.x - middle, 0.0);
    const double u2 = u * u / (d * d);
    const double w2 = p.z * p.z / (w * w);
    const double round = spline(roundness, lowest, step, p.y);
    const double r = std::sqrt(std::sqrt(u2 * u2 + round * u2 * w2 + w2 * w2));
    double f = r > 0.2 ? (r - 1) / r * std::hypot(u, p.z) : -4.0;
    // Below the hairline only; chin, the lower edge of the jaw, and its branch below the ear.
    f = meet(f, p.y - 8, 5);
    f = meet(f, -11.25 - p.y, 2.4);
    f = meet(f, dot(p - Vec3d{5.45, -11.25, 0}, {-0.524, -0.852, 0}), 1.6);
    return meet(f, dot(p - Vec3d{-0.6, -5, 0}, {-0.99, -0.12, 0}), 2.5);
}

}  // namespace

// Braincase, forehead, cheeks and jaw.
double skullField(Vec3d p) {
    const Vec3d side = {p.x, p.y, std::sqrt(p.z * p.z + 0.04)};
    double f = ellipsoid(p, {-1.35, 3.2, 0}, {8.98, 8.15, 7.6});
    f = join(f, ellipsoid(p, {-4.2, 0.6, 0}, {5.95, 5.9, 6.2}), 3);
    f = join(f, ellipsoid(p, {2.3, 3.7, 0}, {6.2, 5.6, 6.0}), 2.0);
    f = join(f, faceBlock(p), 2.0);
    f = join(f, ellipsoid(side, {-2.5, -3.2, 4.8}, {1.5, 1.9, 1.3}), 2.0);  // behind the ear
    f += 0.20 * bump(side, {5.0, 2.4, 6.2}, {4, 3.5, 2.6});                 // temple
    f -= 0.30 * bump(side, {5.4, -2.2, 5.0}, {4.0, 3.2, 3.2});              // cheekbone
    f += 0.25 * bump(side, {4.6, -6.2, 5.0}, {4.0, 3.4, 3.2});              // cheek
    f -= 0.28 * bump(side, {7.6, -9.2, 0.4}, {2.2, 1.7, 2.2});              // chin
    return f;
}

}  // namespace kushi
