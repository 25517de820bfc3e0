// SPDX-License-Identifier: Apache-2.0
//
// The heavy elastica, EI theta'' = (w (L - s) + P) cos(theta), theta(0) = clamp, theta'(L) = 0, on
// nodes: E = sum EI/(2d) (theta_j - theta_(j-1))^2 + W_j d sin((theta_(j-1) + theta_j)/2), where
// W_j is the load beyond the middle of segment j.
#include <kushi/cantilever.h>
#include <kushi/planar_rod.h>

#include <algorithm>
#include <cmath>

namespace kushi {

namespace {

using Angles = std::vector<double>;  // at nodes 0 (the clamp) to n

struct Discrete {
    double d = 0;          // segment length
    double stiffness = 0;  // EI / d
    Angles loads;          // W_j of segment j = 1 .. n, at index j - 1

    double scale = 0;  // of moments: EI/L + w L^2/2 + P L
};

Discrete discretize(const PlanarRod& rod, int segments) {
    Discrete rig;
    rig.d = rod.length / segments;
    rig.stiffness = rod.rigidity / rig.d;
    for (int j = 1; j <= segments; ++j) {
        rig.loads.push_back(rod.weight * (rod.length - (j - 0.5) * rig.d) + rod.tipLoad);
    }
    rig.scale = rod.rigidity / rod.length + rod.weight * rod.length * rod.length / 2 +
                rod.tipLoad * rod.length;
    return rig;
}

double chord(const Angles& theta, std::size_t j) {
    return 0.5 * (theta[j - 1] + theta[j]);
}

double energy(const Discrete& rig, const Angles& theta, double loadShare) {
    double sum = 0;
    for (std::size_t j = 1; j < theta.size(); ++j) {
        const double turn = theta[j] - theta[j - 1];
        sum += 0.5 * rig.stiffness * turn * turn +
               loadShare * rig.loads[j - 1] * rig.d * std::sin(chord(theta, j));
    }
    return sum;
}

// Gradient and tridiagonal Hessian with respect to theta_1 .. theta_n, at indices 0 .. n - 1.
struct Derivatives {
    Angles gradient, diagonal, upper;
};

Derivatives derive(const Discrete& rig, const Angles& theta, double loadShare) {
    const std::size_t n = theta.size() - 1;
    Derivatives result = {Angles(n, 0), Angles(n, 0), Angles(n, 0)};
    for (std::size_t j = 1; j <= n; ++j) {
        const double load = loadShare * rig.loads[j - 1] * rig.d;
        const double moment = rig.stiffness * (theta[j] - theta[j - 1]);
        const double push = 0.5 * load * std::cos(chord(theta, j));
        const double bend = -0.25 * load * std::sin(chord(theta, j));
        result.gradient[j - 1] += moment + push;
        result.diagonal[j - 1] += rig.stiffness + bend;
        if (j == 1) continue;
        result.gradient[j - 2] += -moment + push;
        result.diagonal[j - 2] += rig.stiffness + bend;
        result.upper[j - 2] = -rig.stiffness + bend;
    }
    return result;
}

// Newton step -H^-1 g, or nothing where H + shift is not positive definite.
bool newtonStep(const Derivatives& at, double shift, Angles& step) {
    const std::size_t n = at.gradient.size();
    Angles pivot(n);
    step.resize(n);
    for (std::size_t i = 0; i < n; ++i) {
        const double factor = i == 0 ? 0 : at.upper[i - 1] / pivot[i - 1];
        pivot[i] = at.diagonal[i] + shift - (i == 0 ? 0 : factor * at.upper[i - 1]);
        if (pivot[i] <= 1e-12 * std::abs(at.diagonal[i])) return false;
        step[i] = -at.gradient[i] - (i == 0 ? 0 : factor * step[i - 1]);
    }
    for (std::size_t i = n; i-- > 0;) {
        step[i] = (step[i] - (i + 1 < n ? at.upper[i] * step[i + 1] : 0)) / pivot[i];
    }
    return true;
}

double largest(const Angles& values) {
    double most = 0;
    for (const double value : values)
        most = std::max(most, std::abs(value));
    return most;
}

// Goes down to the nearest minimum of the energy.
void minimize(const Discrete& rig, double loadShare, Angles& theta) {
    Angles step;
    for (int iteration = 0; iteration < 200; ++iteration) {
        const Derivatives at = derive(rig, theta, loadShare);
        bool indefinite = false;
        for (double shift = 0; !newtonStep(at, shift, step); indefinite = true) {
            shift = std::max(4 * shift, 1e-8 * rig.stiffness);
        }
        if (!indefinite && largest(at.gradient) < 1e-13 * rig.scale) return;

        // No node turns by more than half a radian at once, nor does the energy rise.
        double reach = std::min(1.0, 0.5 / std::max(largest(step), 1e-300));
        const double before = energy(rig, theta, loadShare);
        Angles trial = theta;
        for (int halving = 0; halving < 30; ++halving, reach *= 0.5) {
            for (std::size_t i = 0; i < step.size(); ++i)
                trial[i + 1] = theta[i + 1] + reach * step[i];
            if (energy(rig, trial, loadShare) <= before + 1e-12 * std::abs(before)) break;
        }
        theta = trial;
        if (!indefinite && reach * largest(step) < 1e-15) return;
    }
}

Angles equilibrium(const PlanarRod& rod, const Discrete& rig, int segments) {
    Angles theta(static_cast<std::size_t>(segments) + 1, rod.clampAngle);
    const double load =
        (rod.weight * rod.length + rod.tipLoad) * rod.length * rod.length / rod.rigidity;
    for (double grown = std::min(load, 0.5);; grown = std::min(load, 1.25 * grown)) {
        // What stands on its tip's point of balance is pushed forward by a hair's breadth.
        if (std::abs(std::cos(rod.clampAngle)) < 1e-12) theta.back() -= 1e-6;
        minimize(rig, load > 0 ? grown / load : 0, theta);
        if (grown >= load) return theta;
    }
}

// Imbalance on chords: a spring between each two, half a segment's between the clamp and the first.
double chordResidual(const PlanarRod& rod, const Discrete& rig, const Angles& chords) {
    double most = 0;
    for (std::size_t j = 0; j < chords.size(); ++j) {
        const double before = j == 0 ? 2 * (chords[0] - rod.clampAngle) : chords[j] - chords[j - 1];
        const double after = j + 1 < chords.size() ? chords[j + 1] - chords[j] : 0;
        const double imbalance =
            rig.stiffness * (before - after) + rig.loads[j] * rig.d * std::cos(chords[j]);
        most = std::max(most, std::abs(imbalance));
    }
    return most / rig.scale;
}

PlanarShape walk(const PlanarRod& rod, const Discrete& rig, int segments) {
    std::vector<Vec3d> nodes(static_cast<std::size_t>(segments) + 1);
    CantileverWorld world;
    world.tipLoad = {0, -rod.tipLoad, 0};
    const Vec3d direction = {std::cos(rod.clampAngle), std::sin(rod.clampAngle), 0};
    bendCantilever({{}, direction, rod.length, rod.rigidity, rod.weight}, world, nodes);

    PlanarShape shape = {{{0, 0}}, 0};
    Angles chords;
    double last = rod.clampAngle;
    for (std::size_t i = 1; i < nodes.size(); ++i) {
        const Vec3d step = nodes[i] - nodes[i - 1];
        last += std::remainder(std::atan2(step.y, step.x) - last, 2 * std::numbers::pi);
        chords.push_back(last);
        shape.nodes.push_back({nodes[i].x, nodes[i].y});
    }
    shape.residual = chordResidual(rod, rig, chords);
    return shape;
}

}  // namespace

PlanarShape bendPlanarRod(const PlanarRod& rod, int segments, Method method) {
    const Discrete rig = discretize(rod, segments);
    if (method == Method::Cantilever) return walk(rod, rig, segments);

    const Angles theta = equilibrium(rod, rig, segments);
    PlanarShape shape = {{{0, 0}}, largest(derive(rig, theta, 1).gradient) / rig.scale};
    for (std::size_t j = 1; j < theta.size(); ++j) {
        const auto [x, y] = shape.nodes.back();
        shape.nodes.push_back(
            {x + rig.d * std::cos(chord(theta, j)), y + rig.d * std::sin(chord(theta, j))});
    }
    return shape;
}

}  // namespace kushi
