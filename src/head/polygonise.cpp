// SPDX-License-Identifier: Apache-2.0
#include "head/polygonise.h"

#include "core/parallel.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <limits>
#include <optional>

namespace kushi {

namespace {

constexpr std::uint32_t none = std::numeric_limits<std::uint32_t>::max();
constexpr std::size_t blockSize = 6;

using Corner = std::array<std::size_t, 3>;

/// Values of the field at the crossings of the planes; far from the surface only their sign is
/// right.
class Samples {
public:
    Samples(const Field& field, const Grid& grid)
        : grid_(grid), values_(grid.x.size() * grid.y.size() * grid.z.size()) {
        const Corner blocks = {count(grid.x), count(grid.y), count(grid.z)};
        parallelFor(
            blocks[0] * blocks[1] * blocks[2], 8, 0, [&](std::size_t begin, std::size_t end) {
                for (std::size_t i = begin; i < end; ++i) {
                    fill(field,
                         {i % blocks[0], i / blocks[0] % blocks[1], i / blocks[0] / blocks[1]});
                }
            });
    }

    /// A face of the grid whose corners alternate between inside and outside would join four quads
    /// in one edge: the corner nearest the surface changes sides.
    void resolveSaddles() {
        for (bool changed = true; changed;) {
            changed = false;
            for (std::size_t axis = 0; axis < 3; ++axis)
                changed = resolveSaddles(axis) || changed;
        }
    }

    float operator[](Corner at) const { return values_[index(at)]; }

    Vec3d place(Corner at) const { return {grid_.x[at[0]], grid_.y[at[1]], grid_.z[at[2]]}; }

private:
    static std::size_t count(const std::vector<double>& planes) {
        return (planes.size() + blockSize - 1) / blockSize;
    }

    std::size_t index(Corner at) const {
        return (at[2] * grid_.y.size() + at[1]) * grid_.x.size() + at[0];
    }

    bool resolveSaddles(std::size_t axis) {
        Corner faces = {grid_.x.size(), grid_.y.size(), grid_.z.size()};
        Corner u{};
        Corner v{};
        u[(axis + 1) % 3] = v[(axis + 2) % 3] = 1;
        --faces[(axis + 1) % 3];
        --faces[(axis + 2) % 3];
        const std::size_t du = index(u);
        const std::size_t dv = index(v);
        bool changed = false;
        for (std::size_t k = 0; k < faces[2]; ++k) {
            for (std::size_t j = 0; j < faces[1]; ++j) {
                for (std::size_t i = 0; i < faces[0]; ++i) {
                    changed = resolveSaddle(index({i, j, k}), du, dv) || changed;
                }
            }
        }
        return changed;
    }

    bool resolveSaddle(std::size_t at, std::size_t du, std::size_t dv) {
        const std::array corners = {at, at + du, at + du + dv, at + dv};
        const auto inside = [&](std::size_t corner) { return values_[corners[corner]] < 0; };
        if (inside(0) == inside(1) || inside(1) == inside(2) || inside(2) == inside(3))
            return false;
        const auto size = [this](std::size_t corner) { return std::abs(values_[corner]); };
        float& nearest = values_[*std::ranges::min_element(corners, {}, size)];
        nearest = nearest < 0 ? 1e-6F : -1e-6F;
        return true;
    }

    // A block farther from the surface than its own size is all of one sign.
    void fill(const Field& field, Corner block) {
        const Corner sizes = {grid_.x.size(), grid_.y.size(), grid_.z.size()};
        Corner low{};
        Corner high{};
        for (std::size_t k = 0; k < 3; ++k) {
            low[k] = block[k] * blockSize;
            high[k] = std::min(low[k] + blockSize, sizes[k]);
        }
        const Vec3d a = place(low);
        const Vec3d b = place({high[0] - 1, high[1] - 1, high[2] - 1});
        const double atCentre = field(0.5 * (a + b));
        const bool far = std::abs(atCentre) > 0.5 + length(b - a);
        for (std::size_t k = low[2]; k < high[2]; ++k) {
            for (std::size_t j = low[1]; j < high[1]; ++j) {
                for (std::size_t i = low[0]; i < high[0]; ++i) {
                    const double value = far ? atCentre : field(place({i, j, k}));
                    values_[index({i, j, k})] = static_cast<float>(value);
                }
            }
        }
    }

    const Grid& grid_;
    std::vector<float> values_;
};

Vec3d gradient(const Field& field, Vec3d p, double h) {
    const auto across = [&](Vec3d step) { return field(p + step) - field(p - step); };
    return Vec3d{across({h, 0, 0}), across({0, h, 0}), across({0, 0, h})} / (2 * h);
}

/// Which vertex stands for which cell.
class Cells {
public:
    explicit Cells(const Grid& grid)
        : nx_(grid.x.size()), ny_(grid.y.size()), vertex_(nx_ * ny_ * grid.z.size(), none) {}

    /// Cell k = 0 straddles the plane of symmetry, cell k > 0 lies between planes k - 1 and k.
    std::uint32_t& operator[](Corner at) { return vertex_[(at[2] * ny_ + at[1]) * nx_ + at[0]]; }

private:
    std::size_t nx_, ny_;
    std::vector<std::uint32_t> vertex_;
};

/// The mean of the points where the surface crosses the cell's edges, if it does.
std::optional<Vec3d> crossingMean(const Samples& samples, Corner cell) {
    Vec3d sum;
    int crossings = 0;
    const bool onPlane = cell[2] == 0;
    const auto edge = [&](Corner a, Corner b) {
        const double fa = samples[a];
        const double fb = samples[b];
        if ((fa < 0) == (fb < 0)) return;
        sum += samples.place(a) + (fa / (fa - fb)) * (samples.place(b) - samples.place(a));
        ++crossings;
    };
    const std::size_t k0 = onPlane ? 0 : cell[2] - 1;
    const std::size_t k1 = cell[2];
    for (std::size_t k = k0; k <= k1; ++k) {
        for (std::size_t s = 0; s < 2; ++s) {
            edge({cell[0], cell[1] + s, k}, {cell[0] + 1, cell[1] + s, k});
            edge({cell[0] + s, cell[1], k}, {cell[0] + s, cell[1] + 1, k});
        }
    }
    for (std::size_t s = 0; s < 4 && !onPlane; ++s) {
        const std::size_t i = cell[0] + s % 2;
        const std::size_t j = cell[1] + s / 2;
        edge({i, j, k0}, {i, j, k1});
    }
    if (crossings == 0) return std::nullopt;
    if (onPlane) sum.z = 0;
    return sum / crossings;
}

void addVertices(const Samples& samples, const Grid& grid, Cells& cells, HalfSurface& half) {
    for (std::size_t k = 0; k < grid.z.size(); ++k) {
        for (std::size_t j = 0; j + 1 < grid.y.size(); ++j) {
            for (std::size_t i = 0; i + 1 < grid.x.size(); ++i) {
                const std::optional<Vec3d> mean = crossingMean(samples, {i, j, k});
                if (!mean) continue;
                cells[{i, j, k}] = static_cast<std::uint32_t>(half.points.size());
                half.points.push_back(*mean);
                half.onPlane.push_back(k == 0 ? 1 : 0);
            }
        }
    }
}

/// The quad around the edge from `at` along `axis`, if the surface crosses it.
void addQuad(const Samples& samples, Cells& cells, Corner at, std::size_t axis, HalfSurface& half) {
    Corner next = at;
    ++next[axis];
    const bool inside = samples[at] < 0;
    if (inside == (samples[next] < 0)) return;

    // The cell above plane k in z is k + 1. The cells around an edge, counter-clockwise about
    // +axis.
    const std::size_t u = (axis + 1) % 3;
    const std::size_t v = (axis + 2) % 3;
    constexpr std::array<std::array<std::size_t, 2>, 4> around = {{{0, 0}, {1, 0}, {1, 1}, {0, 1}}};
    std::array<std::uint32_t, 4> quad{};
    for (std::size_t corner = 0; corner < 4; ++corner) {
        Corner cell = at;
        ++cell[2];
        cell[u] -= 1 - around[corner][0];
        cell[v] -= 1 - around[corner][1];
        quad[corner] = cells[cell];
    }
    if (!inside) std::swap(quad[1], quad[3]);
    const auto& p = half.points;
    const bool other = length(p[quad[0]] - p[quad[2]]) > length(p[quad[1]] - p[quad[3]]);
    if (other) std::rotate(quad.begin(), quad.begin() + 1, quad.end());
    half.triangles.push_back({quad[0], quad[1], quad[2]});
    half.triangles.push_back({quad[0], quad[2], quad[3]});
}

void addQuads(const Samples& samples, const Grid& grid, Cells& cells, HalfSurface& half) {
    const Corner sizes = {grid.x.size(), grid.y.size(), grid.z.size()};
    for (std::size_t k = 0; k + 1 < sizes[2]; ++k) {
        for (std::size_t j = 1; j + 1 < sizes[1]; ++j) {
            for (std::size_t i = 1; i + 1 < sizes[0]; ++i) {
                for (std::size_t axis = 0; axis < 3; ++axis) {
                    addQuad(samples, cells, {i, j, k}, axis, half);
                }
            }
        }
    }
}

}  // namespace

Vec3d fieldNormal(const Field& field, Vec3d p, double h) {
    return normalized(gradient(field, p, h));
}

Vec3d ontoSurface(const Field& field, Vec3d p, bool onPlane, int steps) {
    for (int step = 0; step < steps; ++step) {
        const Vec3d slope = gradient(field, p, 0.02);
        p = p - (field(p) / std::max(dot(slope, slope), 0.05)) * slope;
        if (onPlane) p.z = 0;
    }
    return p;
}

std::vector<double> gradedPlanes(const std::vector<GridKey>& keys) {
    std::vector<double> planes = {keys.front().at};
    std::size_t next = 1;
    while (planes.back() < keys.back().at) {
        const double at = planes.back();
        while (next + 1 < keys.size() && keys[next].at <= at)
            ++next;
        const GridKey& a = keys[next - 1];
        const GridKey& b = keys[next];
        const double t = (at - a.at) / (b.at - a.at);
        planes.push_back(at + a.spacing + t * (b.spacing - a.spacing));
    }
    return planes;
}

HalfSurface polygonise(const Field& field, const Grid& grid) {
    Samples samples(field, grid);
    samples.resolveSaddles();
    Cells cells(grid);
    HalfSurface half;
    addVertices(samples, grid, cells, half);
    addQuads(samples, grid, cells, half);
    parallelFor(half.points.size(), 256, 0, [&](std::size_t begin, std::size_t end) {
        for (std::size_t i = begin; i < end; ++i) {
            half.points[i] = ontoSurface(field, half.points[i], half.onPlane[i] != 0, 2);
        }
    });
    return half;
}

}  // namespace kushi
