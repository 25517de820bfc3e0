// SPDX-License-Identifier: Apache-2.0
#include "shading/far_field.h"

#include "shading/fibre_model.h"

#include <algorithm>
#include <cmath>
#include <numbers>

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
        auto clear = view.attenuations(0);
        auto tinted = view.attenuations(reference);
        clear[2] += clear[3];
        tinted[2] += tinted[3];
        for (std::size_t j = 0; j < columns; ++j) {
            const double phi = pi * static_cast<double>(j) / static_cast<double>(columns - 1);
            for (std::size_t p = 0; p < 3; ++p) {
                // Both sides of the circle, so that a row of one half holds all.
                const double spread = view.around(p, phi);
                row.clear[j][p] += weight * clear[p] * spread;
                row.tinted[j][p] += weight * tinted[p] * spread;
            }
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

/// Shares sent into the half circle away from the light and back, for light from `theta`.
std::array<double, 2> halves(const Fibre& fibre, double absorption, double theta) {
    const FibreModel<double> model(fibre);
    std::array<double, 2> sums{};
    constexpr int steps = 48;
    constexpr int angles = 48;
    for (int i = 0; i < steps; ++i) {
        const double gamma = -pi / 2 + (i + 0.5) * pi / steps;
        const double weight = 0.5 * std::cos(gamma) * pi / steps;
        const FibreView<double> view(model, std::sin(gamma), std::sin(theta), std::cos(theta));
        const auto shares = view.attenuations(absorption);
        for (std::size_t p = 0; p < 3; ++p) {
            double forward = 0;
            for (int j = 0; j < angles; ++j)
                forward += view.around(p, pi / 2 + (j + 0.5) * pi / angles) * pi / angles;
            sums[0] += weight * shares[p] * forward;
            sums[1] += weight * shares[p] * (1 - forward);
        }
        sums[0] += 0.5 * weight * shares[3];
        sums[1] += 0.5 * weight * shares[3];
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
            const std::array<double, 8> entry = {
                clear[0],
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
    albedos_.reserve(pigments);
    for (std::size_t i = 0; i < pigments; ++i) {
        const double share = static_cast<double>(i) / pigments;
        const double absorption = static_cast<double>(halfway) * share / (1 - share);
        // Fibres that meet light at all angles, most of it square.
        double forward = 0;
        double backward = 0;
        double weights = 0;
        for (const double theta : {0.0, 0.35, 0.7, 1.05}) {
            const double weight = std::cos(theta) * std::cos(theta);
            const auto [on, back] = halves(fibre, absorption, theta);
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

FarField::Around FarField::around(Lanes sinHalf, Lanes phi) const {
    const Lanes row = least(sinHalf, lanes(0.9999F)) * (rows - 1);
    const Lanes column = least(phi * static_cast<float>((columns - 1) / pi),
                               lanes(static_cast<float>(columns - 1) - 0.001F));
    std::array<Entry, 4> mixed;
    for (std::size_t lane = 0; lane < 4; ++lane) {
        const auto i = static_cast<std::size_t>(row[lane]);
        const auto j = static_cast<std::size_t>(column[lane]);
        const float u = row[lane] - static_cast<float>(i);
        const float v = column[lane] - static_cast<float>(j);
        const Entry* const at = &entries_[i * columns + j];
        for (std::size_t k = 0; k < 2; ++k) {
            const Lanes one = at[0][k] + v * (at[1][k] - at[0][k]);
            const Lanes two = at[columns][k] + v * (at[columns + 1][k] - at[columns][k]);
            mixed[lane][k] = one + u * (two - one);
        }
    }
    const auto all = [&](std::size_t k, std::size_t i) {
        return Lanes{mixed[0][k][i], mixed[1][k][i], mixed[2][k][i], mixed[3][k][i]};
    };
    return {all(0, 0), all(0, 1), all(0, 2), all(0, 3), all(1, 0), all(1, 1), all(1, 2), all(1, 3)};
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
