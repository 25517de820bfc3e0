// SPDX-License-Identifier: Apache-2.0
#include "pipeline/lead.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <vector>

namespace kushi {

namespace {

// How far a spring is stretched that pulls as much as the hair weighs [m]. Softer ones lead less
// far, and more smoothly.
constexpr double slack = 0.005;
// Segments that a cut has left shorter count as so long [m].
constexpr double shortest = 1e-4;

// A symmetric, positive definite matrix: of row j, what is at j, j + 1 and j + 2.
using Band = std::vector<std::array<double, 3>>;

// Adds stiffness (a v_j + b v_j+1 + c v_j+2)^2 / 2 to the energy of v.
void addSquare(Band& band, std::size_t j, double stiffness, const std::array<double, 3>& factors) {
    for (std::size_t row = 0; row < 3; ++row)
        for (std::size_t column = row; column < 3 && j + column < band.size(); ++column)
            band[j + row][column - row] += stiffness * factors[row] * factors[column];
}

// `values` becomes the solution.
void solve(Band& band, std::vector<Vec3d>& values) {
    const std::size_t size = band.size();
    for (std::size_t j = 0; j < size; ++j) {
        for (std::size_t k = 1; k < 3 && j + k < size; ++k) {
            const double share = band[j][k] / band[j][0];
            for (std::size_t l = k; l < 3; ++l)
                band[j + k][l - k] -= share * band[j][l];
            values[j + k] = values[j + k] - share * values[j];
        }
    }
    for (std::size_t j = size; j-- > 0;) {
        for (std::size_t k = 1; k < 3 && j + k < size; ++k)
            values[j] = values[j] - band[j][k] * values[j + k];
        values[j] = (1 / band[j][0]) * values[j];
    }
}

}  // namespace

void lead(std::span<Vec3f> nodes, std::span<const Vec3f> ways, float bendLength, float strength,
          std::span<Vec3f> loads) {
    const std::size_t segments = loads.size();
    std::vector<double> lengths;
    for (std::size_t j = 0; j < segments; ++j)
        lengths.push_back(std::max(shortest, double{length(nodes[j + 1] - nodes[j])}));

    // The energy over the weight per length. Two nodes stay where they are: one inside the clamp,
    // as far from the root as the first segment is long, and the root.
    const double stiffness = std::pow(double{bendLength}, 3);
    Band band(segments + 2);
    std::vector<Vec3d> drawn(segments + 2);
    std::vector<Vec3d> moved(segments + 2);
    double beyond = 0;
    for (std::size_t j = segments; j-- > 0;) {
        const double here = lengths[j];
        const double before = j > 0 ? lengths[j - 1] : here;
        const double behind = j + 1 < segments ? lengths[j + 1] : 0;
        const double tension = beyond + 0.5 * here;
        beyond += here;
        addSquare(band, j, 2 * stiffness / (before + here),
                  {1 / before, -1 / before - 1 / here, 1 / here});
        addSquare(band, j + 1, tension / here, {-1, 1, 0});
        const double spring = 0.5 * (here + behind) / slack;
        addSquare(band, j + 2, spring, {1, 0, 0});
        // A cut may have left two nodes at one place.
        const Vec3f chord = nodes[std::min(j + 2, segments)] - nodes[j];
        const float size = length(chord);
        const Vec3f along = size > 0 ? (1 / size) * chord : Vec3f{};
        const Vec3f across = ways[j + 1] - dot(ways[j + 1], along) * along;
        drawn[j + 2] = across.as<double>();
        moved[j + 2] = spring * drawn[j + 2];
    }
    for (std::size_t fixed = 0; fixed < 2; ++fixed)
        band[fixed] = {1, 0, 0};
    solve(band, moved);

    const double pull = strength / slack;
    for (std::size_t j = 0; j < segments; ++j) {
        const Vec3d left = drawn[j + 1] - moved[j + 1] + drawn[j + 2] - moved[j + 2];
        loads[j] = loads[j] + (0.5 * pull * left).as<float>();
        nodes[j + 1] = nodes[j + 1] + moved[j + 2].as<float>();
    }
}

}  // namespace kushi
