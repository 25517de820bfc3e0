// SPDX-License-Identifier: Apache-2.0
#include "head/field.h"
#include "head/shape.h"

namespace kushi {

using namespace field;

namespace {

constexpr Vec3d eye = {5.75, 0.2, 3.1};

double withEyes(Vec3d p, double f) {
    const Vec3d side = {p.x, p.y, std::sqrt(p.z * p.z + 0.01)};
    // Brow; hollows under it that rise towards the nose, deepest beside its root.
    const Vec3d arched = {side.x, side.y + 0.13 * (side.z - 3), side.z};
    f -= 0.12 * bump(arched, {7.6, 2.6, 2.9}, {3.0, 1.8, 3.6});
    f += 0.68 * bump(arched, {7.2, 0.65, 3.1}, {3.2, 2.65, 3.4});
    f += 0.38 * bump(side, {7.4, 0.2, 1.9}, {2.2, 2.3, 1.7});
    // Ball and lids in one: outside the opening between two arcs the ball is thicker by the lid.
    const Vec3d d = side - eye;
    const double upper = std::hypot(d.z - 0.05, d.y + 1.77) - 2.40;
    const double lower = std::hypot(d.z - 0.12, d.y - 2.6) - 3.06;
    const double opening = meet(upper, lower, 0.2);
    const double lid = (0.10 + 0.07 * ramp(-0.3, 0.3, d.y)) * ramp(-0.12, 0.18, opening);
    return join(f, ellipsoid(side, eye, {1.40, 1.36, 1.9}) - lid, 1.0);
}

double withNose(Vec3d p, double f) {
    const Vec3d side = {p.x, p.y, std::sqrt(p.z * p.z + 0.01)};
    double nose = tube(p, {7.75, 1.8, 0}, {9.5, -3.0, 0}, 0.45, 0.58);
    nose = join(nose, tube(p, {7.2, 0.8, 0}, {8.3, -3.3, 0}, 0.5, 1.15), 1.4);
    nose = join(nose, ellipsoid(p, {9.45, -3.25, 0}, {0.95, 0.72, 0.78}), 0.8);
    nose = join(nose, ellipsoid(side, {8.6, -3.55, 0.9}, {0.9, 0.62, 0.58}), 0.7);
    return join(f, nose, 1.2);
}

double withMouth(Vec3d p, double f) {
    const double t = std::abs(p.z) / 2.5;
    const double front = ramp(4.5, 6.5, p.x);
    if (front == 0 || p.y < -10.8 || p.y > -3.2) return f;
    f -= 0.24 * bump(p, {8.2, -6.4, 0}, {3.5, 2.6, 3.0});
    const double line = -6.55 + 0.25 * t * t;
    const double parting = line - 0.09 * std::exp(-t * t / 0.03);
    const double round = std::max(1 - t * t, 0.0);
    const double high = line + 0.20 + 0.72 * round - 0.20 * std::exp(-t * t / 0.025);
    const double low = line - 0.22 - 0.93 * round;
    const auto pad = [](double u) {
        const double v = 1 - std::min(u / 0.55, 1.0);
        return (1 - v * v) * ramp(1.15, 0.5, u);
    };
    const double rise = p.y - parting;
    const double away = std::hypot(rise, 0.08) - 0.08;
    const double pads =
        rise > 0 ? 0.32 * pad(away / (high - parting)) : 0.42 * pad(away / (parting - low));
    const double groove = 0.07 * ramp(1.1, 0.85, t) * std::exp(-rise * rise / 0.017);
    f -= front * (ramp(1.05, 0.45, t) * pads - groove);
    f += 0.12 * bump(p, {9, -5.0, 0}, {2, 1.0, 0.6});  // philtrum
    f += 0.25 * bump(p, {8, -8.4, 0}, {2, 1.1, 2.4});  // under the lower lip
    return f +
           0.10 * bump({p.x, p.y, std::abs(p.z)}, {7.4, -6.5, 2.7}, {1.5, 1.2, 1.1});  // corners
}

}  // namespace

double withFace(Vec3d p, double skull) {
    if (p.x < 2 || p.y < -12 || p.y > 6) return skull;
    return withMouth(p, withNose(p, withEyes(p, skull)));
}

}  // namespace kushi
