// SPDX-License-Identifier: Apache-2.0
#include "head/flip.h"

#include "head/edges.h"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <limits>
#include <utility>

namespace kushi {

namespace {

class Flips {
public:
    Flips(const std::vector<Vec3d>& normals, HalfSurface& half) : normals_(normals), half_(half) {}

    void run() {
        const Edges edges(half_.triangles);
        std::vector<std::array<std::uint32_t, 2>> sides(edges.size(), {none, none});
        for (std::uint32_t t = 0; t < half_.triangles.size(); ++t) {
            for (const std::uint32_t e : edges.ofTriangle(t))
                sides[e][sides[e][0] == none ? 0 : 1] = t;
        }
        std::vector<std::uint8_t> touched(half_.triangles.size(), 0);
        reached_.assign(half_.points.size(), 0);
        for (std::size_t e = 0; e < edges.size(); ++e) {
            const auto [s, t] = sides[e];
            if (t == none || touched[s] != 0 || touched[t] != 0) continue;
            if (flip(edges, s, t, edges.ends(e))) touched[s] = touched[t] = 1;
        }
    }

private:
    static constexpr std::uint32_t none = std::numeric_limits<std::uint32_t>::max();

    double turn(std::uint32_t a, std::uint32_t b) const {
        return length(normals_[a] - normals_[b]);
    }

    /// Smallest angle's worth of a triangle, 1 if equilateral; negative if it faces inwards.
    double quality(const Triangle& t) const {
        const Vec3d u = half_.points[t[1]] - half_.points[t[0]];
        const Vec3d v = half_.points[t[2]] - half_.points[t[0]];
        const Vec3d area = cross(u, v);
        const double sum = dot(u, u) + dot(v, v) + dot(u - v, u - v);
        const Vec3d normal = normals_[t[0]] + normals_[t[1]] + normals_[t[2]];
        return std::copysign(2 * std::sqrt(3.0) * length(area) / sum, dot(area, normal));
    }

    bool flip(const Edges& edges, std::uint32_t s, std::uint32_t t,
              std::pair<std::uint32_t, std::uint32_t> ends) {
        Triangle& one = half_.triangles[s];
        Triangle& two = half_.triangles[t];
        std::size_t k = 0;
        while (one[k] == ends.first || one[k] == ends.second)
            ++k;
        std::size_t l = 0;
        while (two[l] == ends.first || two[l] == ends.second)
            ++l;
        const auto [c, a, b] = std::array{one[k], one[(k + 1) % 3], one[(k + 2) % 3]};
        const std::uint32_t d = two[l];
        if (turn(a, b) < 0.12 || turn(c, d) > 0.7 * turn(a, b)) return false;
        if (edges.contains(c, d) || (reached_[c] != 0 && reached_[d] != 0)) return false;
        const Triangle newOne = {c, a, d};
        const Triangle newTwo = {c, d, b};
        if (std::min(quality(newOne), quality(newTwo)) < 0.35) return false;
        one = newOne;
        two = newTwo;
        reached_[c] = reached_[d] = 1;
        return true;
    }

    const std::vector<Vec3d>& normals_;
    HalfSurface& half_;
    std::vector<std::uint8_t> reached_;  ///< by a new edge
};

}  // namespace

void flipAcrossCreases(const std::vector<Vec3d>& normals, HalfSurface& half) {
    Flips(normals, half).run();
}

}  // namespace kushi
