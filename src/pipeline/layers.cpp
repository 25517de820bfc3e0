// SPDX-License-Identifier: Apache-2.0
#include "pipeline/layers.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>

namespace kushi {

namespace {

constexpr int rows = 45;     // of theta
constexpr int columns = 90;  // of phi
constexpr double pi = std::numbers::pi;
constexpr double steepest = 0.1;  // more is no pile but a bush

// Follicles on a grid of angles.
class Meadow {
public:
    Meadow(const Ellipsoid& ellipsoid, const Follicles& follicles) : ellipsoid_(ellipsoid) {
        for (const EllipsoidAngles angles : follicles.angles)
            ++counts_[index(rowOf(angles), columnOf(angles))];
    }

    static int rowOf(EllipsoidAngles at) {
        return std::clamp(static_cast<int>(at.theta / pi * rows), 0, rows - 1);
    }
    static int columnOf(EllipsoidAngles at) {
        const double turns = at.phi / (2 * pi) + 0.5;
        return std::clamp(static_cast<int>((turns - std::floor(turns)) * columns), 0, columns - 1);
    }

    // Of a row's cells [m].
    double height(int row, int column) const {
        return length(corner(row + 1, column + 0.5) - corner(row, column + 0.5));
    }

    bool bears(int row, int column) const { return counts_[index(row, column)] > 0; }

    // Hairs to the square metre.
    double density(int row, int column) const {
        const double width = length(corner(row + 0.5, column + 1) - corner(row + 0.5, column));
        const double area = std::max(width * height(row, column), 1e-9);
        return counts_[index(row, column)] / area;
    }

private:
    static std::size_t index(int row, int column) {
        return static_cast<std::size_t>(row) * columns + static_cast<std::size_t>(column);
    }
    Vec3d corner(double row, double column) const {
        return ellipsoid_.point({row * pi / rows, (column / columns - 0.5) * 2 * pi});
    }

    const Ellipsoid& ellipsoid_;
    std::array<int, std::size_t{rows} * columns> counts_{};
};

// From the middle of a cell down.
Layer below(const Meadow& meadow, int row, int column, double sectionOverPacking) {
    Layer layer;
    double walked = 0;
    double hairs = 0;  // to the metre across
    double pile = 0;
    for (int r = row; r < rows; ++r) {
        const double step = (r == row ? 0.5 : 1) * meadow.height(r, column);
        walked += step;
        if (!meadow.bears(r, column)) continue;
        hairs += step * meadow.density(r, column);
        layer.reach = static_cast<float>(walked);
        pile = hairs * sectionOverPacking;
    }
    if (walked > 0 && layer.reach > 0)
        layer.slope = static_cast<float>(std::min(steepest, pile / double{layer.reach}));
    return layer;
}

}  // namespace

Layer LayerMap::at(EllipsoidAngles root) const {
    if (cells.empty()) return {};
    const int cell = Meadow::rowOf(root) * columns + Meadow::columnOf(root);
    return cells[static_cast<std::size_t>(cell)];
}

std::vector<Layer> LayerMap::of(std::span<const EllipsoidAngles> roots) const {
    std::vector<Layer> layers;
    if (cells.empty()) return layers;
    for (const EllipsoidAngles root : roots)
        layers.push_back(at(root));
    return layers;
}

LayerMap layerMapOf(const Ellipsoid& ellipsoid, const Follicles& follicles, double diameter,
                    double packing) {
    const Meadow meadow(ellipsoid, follicles);
    const double section = pi / 4 * diameter * diameter / packing;
    LayerMap map;
    for (int row = 0; row < rows; ++row)
        for (int column = 0; column < columns; ++column)
            map.cells.push_back(below(meadow, row, column, section));
    return map;
}

}  // namespace kushi
