// SPDX-License-Identifier: Apache-2.0
#include "shading/far_field.h"

#include "shading/fibre_model.h"

#include <algorithm>
#include <bit>
#include <cmath>
#include <numbers>
#include <span>

namespace kushi {

namespace {

constexpr double pi = std::numbers::pi;
constexpr int acrossSteps = 96;     // over the width of a fibre
constexpr double reference = 0.25;  // absorption at which paths are measured
constexpr float halfway = 0.5F;     // absorption in the middle of the table

/// One row: N_p over phi from 0 to pi, clear and with the reference's absorption.
struct Row {
    std::vector<std::array<double, 3>> clear, tinted;
};

Row rowOf(const FibreModel<double>& model, double sinHalf, std::size_t columns) {
    Row row;
    row.clear.resize(columns);
    row.tinted.resize(columns);
    const double cosHalf = std::sqrt(1 - sinHalf * sinHalf);
    const double step = pi / acrossSteps;
    for (int i = 0; i < acrossSteps; ++i) {
        // h = sin gamma, so that the edges are seen well.
        const double gamma = -pi / 2 + (i + 0.5) * step;
        const double weight = 0.5 * std::cos(gamma) * step;
        const FibreView<double> view(model, std::sin(gamma), sinHalf, cosHalf);
        const auto clear = view.attenuations(0);
        const auto tinted = view.attenuations(reference);
        for (std::size_t j = 0; j < columns; ++j) {
            const double phi = pi * static_cast<double>(j) / static_cast<double>(columns - 1);
            for (std::size_t p = 0; p < 3; ++p) {
                const double spread = view.around(p, phi);
                row.clear[j][p] += weight * clear[p] * spread;
                row.tinted[j][p] += weight * tinted[p] * spread;
            }
            row.clear[j][2] += weight * clear[3] / (2 * pi);
            row.tinted[j][2] += weight * tinted[3] / (2 * pi);
        }
    }
    return row;
}

/// Mean over the angles within a right angle of column j.
double halfCircle(const Row& row, std::size_t j, std::size_t p) {
    const auto last = static_cast<std::ptrdiff_t>(row.clear.size() - 1);
    const std::ptrdiff_t reach = last / 2;
    double sum = 0;
    for (std::ptrdiff_t i = -reach; i <= reach; ++i) {
        std::ptrdiff_t at = std::abs(static_cast<std::ptrdiff_t>(j) + i);
        if (at > last) at = 2 * last - at;
        sum += row.clear[static_cast<std::size_t>(at)][p];
    }
    return sum / static_cast<double>(2 * reach + 1);
}

double pathOf(double clear, double tinted) {
    return clear > 1e-9 && tinted > 1e-12 ? std::log(clear / tinted) / reference : 2;
}

/// One place across a fibre: what it weighs, and how much of each way's light goes on into the half
/// circle away from where it came.
struct Slice {
    double weight;
    FibreView<double> view;
    std::array<double, 4> forward;
};

std::vector<Slice> slicesAt(const FibreModel<double>& model, double theta) {
    constexpr int steps = 48;
    constexpr int angles = 48;
    std::vector<Slice> slices;
    for (int i = 0; i < steps; ++i) {
        const double gamma = -pi / 2 + (i + 0.5) * pi / steps;
        const FibreView<double> view(model, std::sin(gamma), std::sin(theta), std::cos(theta));
        Slice& slice =
            slices.emplace_back(Slice{0.5 * std::cos(gamma) * pi / steps, view, {0, 0, 0, 0.5}});
        for (std::size_t p = 0; p < 3; ++p) {
            for (int j = 0; j < angles; ++j)
                slice.forward[p] += view.around(p, pi / 2 + (j + 0.5) * pi / angles) * pi / angles;
        }
    }
    return slices;
}

/// Shares sent on and back.
std::array<double, 2> halves(std::span<const Slice> slices, double absorption) {
    std::array<double, 2> sums{};
    for (const Slice& slice : slices) {
        const auto shares = slice.view.attenuations(absorption);
        for (std::size_t p = 0; p < 4; ++p) {
            sums[0] += slice.weight * shares[p] * slice.forward[p];
            sums[1] += slice.weight * shares[p] * (1 - slice.forward[p]);
        }
    }
    return sums;
}

/// r of r = b + f^2 r / (1 - b r): what an infinite pile sends back.
double pile(double forward, double backward) {
    const double sum = 1 + backward * backward - forward * forward;
    const double root = std::sqrt(std::max(0.0, sum * sum - 4 * backward * backward));
    return backward > 1e-12 ? (sum - root) / (2 * backward) : 0;
}

}  // namespace

FarField::FarField(const Fibre& fibre) {
    const FibreModel<double> model(fibre);
    entries_.reserve(rows * columns);
    for (std::size_t i = 0; i < rows; ++i) {
        // Light along the fibre itself is left out.
        const double sinHalf =
            std::min(0.98, static_cast<double>(i) / static_cast<double>(rows - 1));
        const Row row = rowOf(model, sinHalf, columns);
        for (std::size_t j = 0; j < columns; ++j) {
            const auto& clear = row.clear[j];
            const auto& tinted = row.tinted[j];
            const std::array<double, 8> entry = {clear[0],
                                                 clear[1],
                                                 clear[2],
                                                 pathOf(clear[1], tinted[1]),
                                                 pathOf(clear[2], tinted[2]),
                                                 halfCircle(row, j, 0),
                                                 halfCircle(row, j, 1),
                                                 halfCircle(row, j, 2)};
            Entry& to = entries_.emplace_back();
            for (std::size_t k = 0; k < 8; ++k)
                to[k / 4][k % 4] = static_cast<float>(entry[k]);
        }
    }
    // Fibres that meet light at all angles, most of it square.
    constexpr std::array<double, 4> angles = {0, 0.35, 0.7, 1.05};
    std::array<std::vector<Slice>, 4> slices;
    for (std::size_t i = 0; i < angles.size(); ++i)
        slices[i] = slicesAt(model, angles[i]);
    albedos_.reserve(pigments);
    for (std::size_t i = 0; i < pigments; ++i) {
        const double share = static_cast<double>(i) / pigments;
        const double absorption = static_cast<double>(halfway) * share / (1 - share);
        double forward = 0;
        double backward = 0;
        double weights = 0;
        for (std::size_t j = 0; j < angles.size(); ++j) {
            const double weight = std::cos(angles[j]) * std::cos(angles[j]);
            const auto [on, back] = halves(slices[j], absorption);
            forward += weight * on;
            backward += weight * back;
            weights += weight;
        }
        forward /= weights;
        backward /= weights;
        albedos_.push_back({static_cast<float>(forward), static_cast<float>(backward),
                            static_cast<float>(pile(forward, backward) - backward)});
    }
}

FarField::Around FarField::around(float sinHalf, float phi) const {
    // Also for what is not a number.
    const auto below = [](float x, float most) { return x < most ? x : most; };
    const float row = below(sinHalf, 0.9999F) * (rows - 1);
    const float column = below(phi * static_cast<float>((columns - 1) / pi),
                               static_cast<float>(columns - 1) - 0.001F);
    const auto i = static_cast<std::size_t>(row);
    const auto j = static_cast<std::size_t>(column);
    const float u = row - static_cast<float>(i);
    const float v = column - static_cast<float>(j);
    const Entry* const at = &entries_[i * columns + j];
    Entry mixed;
    for (std::size_t k = 0; k < 2; ++k) {
        const Float4 one = at[0][k] + v * (at[1][k] - at[0][k]);
        const Float4 two = at[columns][k] + v * (at[columns + 1][k] - at[columns][k]);
        mixed[k] = one + u * (two - one);
    }
    return std::bit_cast<Around>(mixed);
}

FarField::Albedo FarField::albedo(float absorption) const {
    const float place = absorption / (absorption + halfway) * pigments;
    const auto i = std::min(static_cast<std::size_t>(place), pigments - 2);
    const float share = std::min(place - static_cast<float>(i), 1.0F);
    const Albedo& a = albedos_[i];
    const Albedo& b = albedos_[i + 1];
    const auto mix = [share](float x, float y) { return x + share * (y - x); };
    return {mix(a.forward, b.forward), mix(a.backward, b.backward), mix(a.local, b.local)};
}

}  // namespace kushi
