// SPDX-License-Identifier: Apache-2.0
//
// Energies written down again from their definitions, and differentiated by finite differences.
#include "rod/kernel/curly-inl.h"

#include <algorithm>
#include <cmath>
#include <random>

#include <gtest/gtest.h>

namespace kushi {
namespace {

using namespace HWY_NAMESPACE;  // NOLINT: the kernels of the processor that everybody has

struct Draw {
    std::mt19937 generator{1992};
    std::normal_distribution<double> normal;

    double operator()() { return normal(generator); }
    V3<double> vector() { return {normal(generator), normal(generator), normal(generator)}; }
    Quaternion<double> frame() { return unitQuaternion<double>({(*this)(), vector()}); }
};

template <int R>
Column<double, R> along(int axis, double size) {
    Column<double, R> step{};
    step[axis] = size;
    return step;
}

// Largest differences between what derive() says and central differences of the energy of one
// segment in turns of its nodes by Element::turned().
struct Differences {
    double gradient = 0, hessian = 0, chord = 0;
};

template <class Element, class Energy>
Differences differences(const typename Element::Segment& segment, const typename Element::State& a,
                        const typename Element::State& b, const V3<double>& force,
                        const Energy& energyOf) {
    constexpr int m = Element::freedoms;
    using Turn = Column<double, m>;
    const double h = 2e-4;
    const auto d = Element::template derive<Order::Hessian>(segment, a, b, force, true);
    const auto energy = [&](const Turn& alpha, const Turn& beta) {
        return energyOf(Element::turned(a, alpha), Element::turned(b, beta));
    };
    const auto chord = [&](const Turn& alpha, const Turn& beta) {
        return Element::chord(segment, Element::turned(a, alpha), Element::turned(b, beta));
    };
    // Second derivative of f(s, t) at 0.
    const auto second = [&](const auto& f) {
        return (f(h, h) - f(h, -h) - f(-h, h) + f(-h, -h)) / (4 * h * h);
    };
    const Turn none{};
    Differences worst;
    const auto note = [](double& largest, double x) { largest = std::max(largest, std::abs(x)); };
    for (int i = 0; i < m; ++i) {
        const Turn up = along<m>(i, h);
        const Turn down = along<m>(i, -h);
        note(worst.gradient, (energy(up, none) - energy(down, none)) / (2 * h) - d.ga[i]);
        note(worst.gradient, (energy(none, up) - energy(none, down)) / (2 * h) - d.gb[i]);
        const V3<double> moveA = (0.5 / h) * (chord(up, none) - chord(down, none));
        const V3<double> moveB = (0.5 / h) * (chord(none, up) - chord(none, down));
        for (int r = 0; r < 3; ++r) {
            note(worst.chord, moveA[r] - d.a(r, i));
            note(worst.chord, moveB[r] - d.b(r, i));
        }
        for (int k = 0; k < m; ++k) {
            note(worst.hessian, second([&](double s, double t) {
                                    return energy(along<m>(i, s) + along<m>(k, t), none);
                                }) - d.haa(i, k));
            note(worst.hessian, second([&](double s, double t) {
                                    return energy(none, along<m>(i, s) + along<m>(k, t));
                                }) - d.hbb(i, k));
            note(worst.hessian, second([&](double s, double t) {
                                    return energy(along<m>(i, s), along<m>(k, t));
                                }) - d.hab(i, k));
        }
    }
    return worst;
}

// Central differences with a step of 2e-4 err by some 1e-7 times the fourth derivatives, which grow
// towards opposite tangents.
void expectSmall(const Differences& worst) {
    EXPECT_LT(worst.gradient, 1e-5);
    EXPECT_LT(worst.hessian, 1e-4);
    EXPECT_LT(worst.chord, 1e-6);
}

TEST(StraightSegment, DerivativesAreThoseOfItsEnergy) {
    Draw draw;
    Differences worst;
    for (int i = 0; i < 500; ++i) {
        const Straight<double>::Segment segment = {0.3, 1, 0.7};
        const V3<double> a = unit(draw.vector());
        // From all but in line to 120 degrees apart.
        const V3<double> b = unit(a + (i % 2 == 0 ? 0.01 : 0.9) * draw.vector());
        if (dot(a, b) < -0.5) continue;
        const V3<double> force = 3.0 * draw.vector();
        const auto energy = [&](const V3<double>& p, const V3<double>& q) {
            const V3<double> n = cross(p, q);
            const double theta = std::atan2(std::sqrt(dot(n, n)), dot(p, q));
            return 0.5 * segment.bend * theta * theta - segment.length * dot(force, unit(p + q));
        };
        const Differences one = differences<Straight<double>>(segment, a, b, force, energy);
        worst = {std::max(worst.gradient, one.gradient), std::max(worst.hessian, one.hessian),
                 std::max(worst.chord, one.chord)};
    }
    expectSmall(worst);
}

// The relative rotation may pass 180 degrees: a tight curl on few segments.
TEST(CurlySegment, DerivativesAreThoseOfItsEnergyBeyondHalfATurn) {
    Draw draw;
    Differences worst;
    int beyond = 0;
    for (int i = 0; i < 1000; ++i) {
        const Curly<double>::Segment segment = {
            0.3, 1, 0.7, 0.45, 2.0 * draw.vector(), 0.3 * unit(draw.vector())};
        const Quaternion<double> a = draw.frame();
        const V3<double> axis = unit(draw.vector());
        // The mid frame is not defined a full turn apart, nor the strain's derivative at half.
        const double angle = 1.45 * std::numbers::pi * (i + 1) / 1000;
        if (std::abs(angle - std::numbers::pi) < 0.3) continue;
        beyond += angle > std::numbers::pi ? 1 : 0;
        const Quaternion<double> b =
            product(a, Quaternion<double>{std::cos(0.5 * angle), std::sin(0.5 * angle) * axis});
        const V3<double> force = 3.0 * draw.vector();
        const auto energy = [&](const Quaternion<double>& p, const Quaternion<double>& q) {
            const Quaternion<double> r = product({p.w, -1.0 * p.v}, q);
            const double sine = std::sqrt(dot(r.v, r.v));
            const V3<double> gap = (2 * std::atan2(sine, r.w) / sine) * r.v - segment.rest;
            const Quaternion<double> m = unitQuaternion<double>({p.w + q.w, p.v + q.v});
            return 0.5 * (segment.bend * (gap[0] * gap[0] + gap[1] * gap[1]) +
                          segment.twist * gap[2] * gap[2]) -
                   dot(force, rotation(m) * segment.chord);
        };
        const Differences one = differences<Curly<double>>(segment, a, b, force, energy);
        worst = {std::max(worst.gradient, one.gradient), std::max(worst.hessian, one.hessian),
                 std::max(worst.chord, one.chord)};
    }
    EXPECT_GT(beyond, 200);
    expectSmall(worst);
}

// A half turn is an ordinary rotation for the strain, if not for the formula.
TEST(CurlySegment, HasFiniteDerivativesAtHalfATurn) {
    Draw draw;
    for (const double angle :
         {std::numbers::pi - 1e-9, std::numbers::pi, std::numbers::pi + 1e-9}) {
        const Quaternion<double> a = draw.frame();
        const Quaternion<double> b = product(
            a,
            Quaternion<double>{std::cos(0.5 * angle), std::sin(0.5 * angle) * unit(draw.vector())});
        const Curly<double>::Segment segment = {0.3, 1, 0.7, 0.45, {3, 0, 0}, {0, 0, 0.3}};
        const auto d = Curly<double>::derive<Order::Hessian>(segment, a, b, draw.vector(), false);
        for (int r = 0; r < 3; ++r) {
            EXPECT_TRUE(std::isfinite(d.ga[r]) && std::isfinite(d.gb[r])) << angle;
            for (int c = 0; c < 3; ++c)
                EXPECT_TRUE(std::isfinite(d.haa(r, c)) && std::isfinite(d.hab(r, c))) << angle;
        }
    }
}

}  // namespace
}  // namespace kushi
