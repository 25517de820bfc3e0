// SPDX-License-Identifier: Apache-2.0
#include "scalp/lattice.h"

#include <algorithm>
#include <cmath>
#include <numbers>

namespace kushi {

namespace {

constexpr double pi = std::numbers::pi;

// Integral of `speed` over each of `steps` equal pieces of [0, end] by Simpson's rule.
template <class Speed>
std::vector<double> stepLengths(double end, int steps, const Speed& speed) {
    const double h = end / steps;
    std::vector<double> lengths;
    lengths.reserve(static_cast<std::size_t>(steps));
    for (int i = 0; i < steps; ++i) {
        const double sum = speed(i * h) + 4 * speed((i + 0.5) * h) + speed((i + 1) * h);
        lengths.push_back(sum * h / 6);
    }
    return lengths;
}

}  // namespace

ArcLength::ArcLength(double begin, double end, const std::vector<double>& stepLengths)
    : begin_(begin), step_((end - begin) / static_cast<double>(stepLengths.size())), lengths_{0} {
    for (const double l : stepLengths)
        lengths_.push_back(lengths_.back() + l);
}

double ArcLength::parameterAt(double s) const {
    const auto after = std::upper_bound(lengths_.begin() + 1, lengths_.end() - 1, s);
    const double low = *(after - 1);
    const double share = *after > low ? (s - low) / (*after - low) : 0;
    return begin_ + step_ * (static_cast<double>(after - lengths_.begin() - 1) + share);
}

double meridianSpeed(const Ellipsoid& e, EllipsoidAngles at) {
    const double across =
        std::hypot(e.semiAxes.x * std::cos(at.phi), e.semiAxes.z * std::sin(at.phi));
    return std::hypot(across * std::cos(at.theta), e.semiAxes.y * std::sin(at.theta));
}

double areaSpeed(const Ellipsoid& e, EllipsoidAngles at) {
    const Vec3d a = e.semiAxes;
    const double st = std::sin(at.theta);
    const double ct = std::cos(at.theta);
    const double sp = std::sin(at.phi);
    const double cp = std::cos(at.phi);
    const Vec3d byTheta = {a.x * ct * cp, -a.y * st, a.z * ct * sp};
    const Vec3d byPhi = {-a.x * st * sp, 0, a.z * st * cp};
    return length(cross(byTheta, byPhi));
}

ArcLength meanMeridian(const Ellipsoid& ellipsoid) {
    // The integrand is smooth and periodic in phi: equal steps converge exponentially.
    constexpr int meridians = 32;
    const auto meanSpeed = [&](double theta) {
        double sum = 0;
        for (int i = 0; i < meridians; ++i) {
            sum += meridianSpeed(ellipsoid, {theta, 2 * pi * i / meridians});
        }
        return sum / meridians;
    };
    return {0, pi, stepLengths(pi, 512, meanSpeed)};
}

ArcLength equator(const Ellipsoid& e) {
    const auto speed = [&](double phi) {
        return std::hypot(e.semiAxes.x * std::sin(phi), e.semiAxes.z * std::cos(phi));
    };
    return {0, 2 * pi, stepLengths(2 * pi, 256, speed)};
}

}  // namespace kushi
