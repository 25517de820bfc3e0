// SPDX-License-Identifier: Apache-2.0
#include "shading/crossings.h"

#include <algorithm>
#include <cmath>

namespace kushi {

namespace {

/// A layer of cubes across the axis that light runs along most, with a rim of air.
class Layer {
public:
    Layer(int rows, int columns)
        : width_(static_cast<std::size_t>(columns + low + high)),
          crossed_(static_cast<std::size_t>(rows + low + high) * width_),
          perMetre_(crossed_.size()) {}

    float& crossed(int row, int column) { return crossed_[index(row, column)]; }
    float& perMetre(int row, int column) { return perMetre_[index(row, column)]; }

    /// Between the cubes (row, column), (row + 1, column) and so on.
    struct Between {
        float rowShare, columnShare;

        float of(const float* at, std::size_t width) const {
            const float one = at[0] + columnShare * (at[1] - at[0]);
            const float two = at[width] + columnShare * (at[width + 1] - at[width]);
            return one + rowShare * (two - one);
        }
    };
    float crossed(int row, int column, Between between) const {
        return between.of(&crossed_[index(row, column)], width_);
    }
    float perMetre(int row, int column, Between between) const {
        return between.of(&perMetre_[index(row, column)], width_);
    }

private:
    // Light comes from at most one cube aside.
    static constexpr int low = 1;
    static constexpr int high = 2;

    std::size_t index(int row, int column) const {
        return static_cast<std::size_t>(row + low) * width_ +
               static_cast<std::size_t>(column + low);
    }

    std::size_t width_;
    std::vector<float> crossed_, perMetre_;
};

}  // namespace

std::vector<float> crossingsTowards(const HairGrid& grid, Vec3f towardsLight, float ahead) {
    std::vector<float> crossed(grid.cells.size());
    if (grid.empty()) return crossed;
    const std::array<float, 3> towards = {towardsLight.x, towardsLight.y, towardsLight.z};
    std::size_t axis = 0;
    for (std::size_t i = 1; i < 3; ++i) {
        if (std::abs(towards[i]) > std::abs(towards[axis])) axis = i;
    }
    const std::size_t rowAxis = axis == 0 ? 1 : 0;
    const std::size_t columnAxis = axis == 2 ? 1 : 2;
    const float most = std::abs(towards[axis]);
    const float aside = towards[rowAxis] / most;
    const float along = towards[columnAxis] / most;
    const int rowStep = static_cast<int>(std::floor(aside));
    const int columnStep = static_cast<int>(std::floor(along));
    const Layer::Between between = {aside - static_cast<float>(rowStep),
                                    along - static_cast<float>(columnStep)};
    const float half = 0.5F * grid.size / most;
    const float share = ahead * most;

    const std::array<std::size_t, 3> strides = grid.strides();
    const int layers = grid.counts[axis];
    const int rows = grid.counts[rowAxis];
    const int columns = grid.counts[columnAxis];
    Layer before(rows, columns);
    Layer here(rows, columns);
    for (int i = 0; i < layers; ++i) {
        const int layer = towards[axis] > 0 ? layers - 1 - i : i;
        for (int row = 0; row < rows; ++row) {
            std::size_t cell = static_cast<std::size_t>(layer) * strides[axis] +
                               static_cast<std::size_t>(row) * strides[rowAxis];
            for (int column = 0; column < columns; ++column, cell += strides[columnAxis]) {
                const float perMetre = grid.cells[cell].crossings(towardsLight);
                const float sofar = before.crossed(row + rowStep, column + columnStep, between);
                const float onTheWay =
                    half *
                    (perMetre + before.perMetre(row + rowStep, column + columnStep, between));
                here.perMetre(row, column) = perMetre;
                here.crossed(row, column) = sofar + onTheWay;
                // Where there is no hair, none of it is its own.
                crossed[cell] = sofar + (perMetre > 0 ? 1 - share : 1) * onTheWay;
            }
        }
        std::swap(before, here);
    }
    return crossed;
}

}  // namespace kushi
