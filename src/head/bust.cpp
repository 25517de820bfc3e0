// SPDX-License-Identifier: Apache-2.0
#include "head/field.h"
#include "head/shape.h"

namespace kushi {

using namespace field;

double bustField(Vec3d p) {
    const Vec3d side = {p.x, p.y, std::sqrt(p.z * p.z + 0.04)};
    double neck = tube(p, {-2.3, -4, 0}, {-4.6, -19, 0}, 4.8, 4.7);
    neck = join(neck, tube(side, {-2.6, -4.0, 4.6}, {-1.1, -19.6, 1.7}, 0.7, 0.5), 2.4);
    // Trapezius, shoulders with the beginning of the arms, chest.
    double body = ellipsoid(p, {-5.0, -31.5, 0}, {8.2, 11.5, 17.5});
    body = join(body, tube(side, {-5.8, -20.5, 2}, {-5.4, -24.3, 14.6}, 2.6, 3.8), 5.0);
    body = join(body, tube(side, {-5.4, -24.3, 14.6}, {-5.0, -36, 11.0}, 3.8, 6.0), 8.0);
    body = join(body, tube(side, {-5.0, -12, 1.5}, {-6.0, -21.3, 10}, 2.0, 2.2), 5.0);
    body = join(body, tube(side, {-0.9, -20.6, 1.9}, {-4.4, -22.0, 13.5}, 0.5, 0.4), 2.4);
    double f = join(neck, body, 5.0);
    f = meet(f, ellipsoid({p.x, std::min(p.y, -23.0), p.z}, {-5, -23, 0}, {300, 11.0, 19.2}), 1.2);
    return meet(f, -33.0 - p.y, 1.2);
}

double mannequinField(Vec3d p) {
    const double bust = p.y < 5 ? bustField(p) : 1e3;
    if (p.y < -14) return bust;
    const double head = withEars(p, withFace(p, skullField(p)));
    return join(head, bust, 1.4 + 3.0 * ramp(2, -4, p.x));
}

}  // namespace kushi
