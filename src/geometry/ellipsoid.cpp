// SPDX-License-Identifier: Apache-2.0
#include <kushi/ellipsoid.h>

#include <algorithm>
#include <cmath>

namespace kushi {

namespace {

Vec3d divide(Vec3d a, Vec3d b) {
    return {a.x / b.x, a.y / b.y, a.z / b.z};
}
Vec3d multiply(Vec3d a, Vec3d b) {
    return {a.x * b.x, a.y * b.y, a.z * b.z};
}

Vec3d rotateAboutZ(Vec3d v, double angle) {
    const double c = std::cos(angle);
    const double s = std::sin(angle);
    return {c * v.x - s * v.y, s * v.x + c * v.y, v.z};
}

}  // namespace

Vec3d Ellipsoid::toLocal(Vec3d world) const {
    return rotateAboutZ(world - center, -rotateZ);
}

Vec3d Ellipsoid::toWorldDirection(Vec3d local) const {
    return rotateAboutZ(local, rotateZ);
}

Vec3d Ellipsoid::point(EllipsoidAngles at) const {
    const Vec3d unit = {std::sin(at.theta) * std::cos(at.phi), std::cos(at.theta),
                        std::sin(at.theta) * std::sin(at.phi)};
    return center + toWorldDirection(multiply(semiAxes, unit));
}

EllipsoidAngles Ellipsoid::angles(Vec3d world) const {
    const Vec3d scaled = divide(toLocal(world), semiAxes);
    const double phi = std::atan2(scaled.z, scaled.x);
    return {std::atan2(std::hypot(scaled.x, scaled.z), scaled.y),
            phi < std::numbers::pi ? phi : -std::numbers::pi};
}

double Ellipsoid::implicit(Vec3d world) const {
    const Vec3d scaled = divide(toLocal(world), semiAxes);
    return dot(scaled, scaled) - 1;
}

Vec3d Ellipsoid::normal(Vec3d world) const {
    const Vec3d gradient = divide(divide(toLocal(world), semiAxes), semiAxes);
    const double size = length(gradient);
    return size > 0 ? toWorldDirection(gradient) / size : Vec3d{0, 1, 0};
}

// The nearest surface point x of an inner point p satisfies x_k = r_k^2 p_k / (r_k^2 + t) for the t
// in
// (-min r^2, 0] that puts x on the surface; the condition falls monotonically in t, so bisection
// finds it (Eberly, "Distance from a point to an ellipse, an ellipsoid, or a hyperellipsoid",
// 2013).
double Ellipsoid::depth(Vec3d world) const {
    if (implicit(world) >= 0) return 0;
    const Vec3d p = toLocal(world);
    const Vec3d squares = multiply(semiAxes, semiAxes);
    const double smallest = std::min({squares.x, squares.y, squares.z});

    const auto nearest = [&](double t) {
        const auto one = [t](double p_k, double r2) { return r2 * p_k / std::max(r2 + t, 1e-300); };
        return Vec3d{one(p.x, squares.x), one(p.y, squares.y), one(p.z, squares.z)};
    };
    double low = -smallest;
    double high = 0;
    for (int i = 0; i < 100; ++i) {
        const double middle = 0.5 * (low + high);
        const Vec3d scaled = divide(nearest(middle), semiAxes);
        (dot(scaled, scaled) > 1 ? low : high) = middle;
    }

    // On the plane of symmetry across a shortest axis the limit t = -min r^2 does not reach the
    // surface; what is missing lies along that axis.
    Vec3d x = nearest(high);
    const Vec3d scaled = divide(x, semiAxes);
    const double missing = 1 - dot(scaled, scaled);
    if (missing > 1e-9) {
        double& shortest = squares.x == smallest ? x.x : (squares.y == smallest ? x.y : x.z);
        shortest += std::copysign(std::sqrt(missing * smallest), shortest);
    }
    return length(x - p);
}

}  // namespace kushi
