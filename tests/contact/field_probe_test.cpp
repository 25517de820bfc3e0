// SPDX-License-Identifier: Apache-2.0
#include "contact/field_probe.h"

#include "core/random.h"
#include "rod/analytic_field.h"

#include <limits>
#include <random>

#include <gtest/gtest.h>

namespace kushi {
namespace {

constexpr double h = 0.0025;  // m

class Places {
public:
    double between(double low, double high) {
        return std::uniform_real_distribution<double>(low, high)(engine_);
    }
    Vec3d in(double low, double high) {
        const double x = between(low, high), y = between(low, high);
        return {x, y, between(low, high)};
    }
    Vec3d direction() {
        while (true) {
            const Vec3d v = in(-1, 1);
            if (length(v) > 0.1 && length(v) < 1) return normalized(v);
        }
    }

private:
    std::mt19937_64 engine_{7};
};

Vec3d gradientOf(const FieldProbe& seen) {
    return {seen.gradient[0], seen.gradient[1], seen.gradient[2]};
}

Vec3d times(const std::array<float, 6>& hessian, Vec3d v) {
    const auto& [xx, yy, zz, xy, yz, zx] = hessian;
    return {double{xx} * v.x + double{xy} * v.y + double{zx} * v.z,
            double{xy} * v.x + double{yy} * v.y + double{yz} * v.z,
            double{zx} * v.x + double{yz} * v.y + double{zz} * v.z};
}

// Samples and slopes that are whole numbers of units: nothing is rounded.
TEST(FieldProbe, OfALinearFieldIsExact) {
    const Vec3d slope = {0.375, 0.5, -0.125};
    const auto plane = [&](Vec3d at) { return dot(slope, at) + 3.0 / 512; };
    const DistanceField field = rest::sampled({0, -1.0 / 16, 0}, {0.05, 0, 0.04}, 1.0 / 512, plane);
    Places places;
    for (int i = 0; i < 1000; ++i) {
        const Vec3d at = {places.between(0.005, 0.045), places.between(-0.055, -0.008),
                          places.between(0.005, 0.034)};
        const FieldProbe seen = probe(field, at.as<float>());
        EXPECT_NEAR(seen.distance, plane(at), 2e-8);
        EXPECT_LT(length(gradientOf(seen) - slope), 1e-5);
        for (const float bend : seen.hessian)
            EXPECT_NEAR(bend, 0, 1e-2);  // of 1 / spacing = 512
    }
}

// Of a sphere: the outward normal, 1/r across it, and all deeper by k h^2 / 8 with k = 2/r. Each
// sample is rounded by up to half a unit, on the mean by nothing.
TEST(FieldProbe, OfASphereIsItsOwnAndSmoothedAsDocumented) {
    for (const double radius : {0.02, 0.09}) {
        const auto sphere = [&](Vec3d at) { return rest::sphereDistance(at, {}, radius); };
        const double edge = radius + 0.02;
        const DistanceField field =
            rest::sampled({-edge, -edge, -edge}, {edge, edge, edge}, h, sphere);
        const double unit = h / 256;
        Places places;
        double bias = 0, across = 0, along = 0;
        constexpr int count = 4000;
        for (int i = 0; i < count; ++i) {
            const Vec3d normal = places.direction();
            const Vec3d at = (radius + places.between(-0.004, 0.008)) * normal;
            const double r = length(at);
            const FieldProbe seen = probe(field, at.as<float>());
            const double expected = h * h / (4 * r);
            EXPECT_NEAR(seen.distance - sphere(at), expected, 0.5 * unit);
            EXPECT_LT(length(gradientOf(seen) - normal), 0.009);
            const Vec3d side = normalized(cross(normal, places.direction()));
            EXPECT_NEAR(r * dot(side, times(seen.hessian, side)), 1, 0.1 + 3 * r);
            bias += (seen.distance - sphere(at)) / expected / count;
            across += r * dot(side, times(seen.hessian, side)) / count;
            along += r * dot(normal, times(seen.hessian, normal)) / count;
        }
        EXPECT_NEAR(bias, 1, 0.02) << radius;
        EXPECT_NEAR(across, 1, 0.03) << radius;
        EXPECT_NEAR(along, 0, 0.03) << radius;
    }
}

// Any samples at all: within a cell the field is quadratic along each axis.
DistanceField noise() {
    DistanceField field;
    field.origin = {-0.02F, 0.01F, 0.03F};
    field.spacing = static_cast<float>(h);
    field.size = {12, 11, 13};
    for (std::uint64_t i = 0; i < field.index(0, 0, field.size[2]); ++i)
        field.units.push_back(static_cast<std::int16_t>(3000 * uniformSigned(mixKey(i, 5))));
    return field;
}

Vec3f onGrid(const DistanceField& field, Vec3d u) {
    return (field.origin.as<double>() + double{field.spacing} * u).as<float>();
}

TEST(FieldProbe, GradientAndHessianAreDerivatives) {
    const DistanceField field = noise();
    Places places;
    const Vec3d axes[] = {{1, 0, 0}, {0, 1, 0}, {0, 0, 1}};
    constexpr double step = 0.1;  // spacings
    const double scale = 3000.0 / 256;
    for (int i = 0; i < 500; ++i) {
        const auto coordinate = [&] {
            return std::floor(places.between(3, 8)) + places.between(-0.38, 0.38);
        };
        const double x = coordinate(), y = coordinate();
        const Vec3d u = {x, y, coordinate()};
        const FieldProbe here = probe(field, onGrid(field, u));
        for (std::size_t axis = 0; axis < 3; ++axis) {
            const Vec3f low = onGrid(field, u - step * axes[axis]);
            const Vec3f high = onGrid(field, u + step * axes[axis]);
            const double apart = length(high.as<double>() - low.as<double>());
            const FieldProbe before = probe(field, low);
            const FieldProbe after = probe(field, high);
            EXPECT_NEAR((double{after.distance} - before.distance) / apart, here.gradient[axis],
                        2e-4 * scale);
            const Vec3d bend = (1 / apart) * (gradientOf(after) - gradientOf(before));
            EXPECT_LT(length(bend - times(here.hessian, axes[axis])), 1e-3 * scale / h);
        }
    }
}

TEST(FieldProbe, ValueAndGradientHaveNoJumps) {
    const DistanceField field = noise();
    Places places;
    const Vec3d axes[] = {{1, 0, 0}, {0, 1, 0}, {0, 0, 1}};
    const double scale = 3000.0 / 256;
    for (int i = 0; i < 300; ++i) {
        for (const Vec3d axis : axes) {
            // On the border between two cells, half way between samples.
            const Vec3d u = places.in(3, 8);
            const Vec3d border = u + (std::floor(dot(u, axis)) + 0.5 - dot(u, axis)) * axis;
            const FieldProbe before = probe(field, onGrid(field, border - 1e-4 * axis));
            const FieldProbe after = probe(field, onGrid(field, border + 1e-4 * axis));
            EXPECT_NEAR(before.distance, after.distance, 1e-3 * scale * h);
            EXPECT_LT(length(gradientOf(before) - gradientOf(after)), 5e-3 * scale);
        }
    }
}

TEST(FieldProbe, IsAMetreAwayOutsideOfTheGrid) {
    const DistanceField field = noise();
    const double nan = std::numeric_limits<double>::quiet_NaN();
    const double inf = std::numeric_limits<double>::infinity();
    const Vec3d middle = {6, 5, 6};
    const Vec3d last = {11, 10, 12};
    for (const double far : {-0.6, -1.0, -1e3, 1e9, -1e9, 1e30, nan, inf, -inf}) {
        for (const Vec3d u : {Vec3d{far, 5, 6}, Vec3d{6, far, 6}, Vec3d{6, 5, far}}) {
            const FieldProbe seen = probe(field, onGrid(field, u));
            EXPECT_EQ(seen.distance, 1) << far;
            EXPECT_EQ(length(gradientOf(seen)), 0) << far;
        }
    }
    for (const Vec3d beyond : {Vec3d{11.6, 0, 0}, Vec3d{0, 10.6, 0}, Vec3d{0, 0, 12.6}}) {
        const Vec3d u = {std::max(beyond.x, middle.x), std::max(beyond.y, middle.y),
                         std::max(beyond.z, middle.z)};
        EXPECT_EQ(probe(field, onGrid(field, u)).distance, 1);
    }
    // Two spacings from the border it is known.
    for (const Vec3d u : {Vec3d{2, 2, 2}, last - Vec3d{2, 2, 2}})
        EXPECT_LT(std::abs(probe(field, onGrid(field, u)).distance), 0.1F);
}

}  // namespace
}  // namespace kushi
