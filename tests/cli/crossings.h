// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <kushi/mesh.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <map>
#include <span>
#include <vector>

namespace kushi::test {

/// Finds polylines that cross a mesh, with the triangles sorted into cubes of a centimetre.
class Crossings {
public:
    explicit Crossings(const Mesh& mesh) : mesh_(mesh) {
        for (std::uint32_t i = 0; i < mesh.triangles.size(); ++i) {
            const auto& [a, b, c] = mesh.triangles[i];
            forEachCube({mesh.vertices[a], mesh.vertices[b], mesh.vertices[c]},
                        [&](const Cube& cube) { cubes_[cube].push_back(i); });
        }
    }

    bool crosses(std::span<const Vec3f> nodes) const {
        for (std::size_t i = 1; i < nodes.size(); ++i) {
            if (segmentCrosses(nodes[i - 1], nodes[i])) return true;
        }
        return false;
    }

private:
    using Cube = std::array<int, 3>;

    template <class Visit>
    static void forEachCube(std::initializer_list<Vec3f> points, Visit visit) {
        Cube low = {1 << 20, 1 << 20, 1 << 20};
        Cube high = {-(1 << 20), -(1 << 20), -(1 << 20)};
        for (const Vec3f p : points) {
            const std::array<float, 3> at = {p.x, p.y, p.z};
            for (std::size_t k = 0; k < 3; ++k) {
                const int cell = static_cast<int>(std::floor(100 * at[k]));
                low[k] = std::min(low[k], cell);
                high[k] = std::max(high[k], cell);
            }
        }
        for (int x = low[0]; x <= high[0]; ++x) {
            for (int y = low[1]; y <= high[1]; ++y) {
                for (int z = low[2]; z <= high[2]; ++z)
                    visit({x, y, z});
            }
        }
    }

    bool segmentCrosses(Vec3f from, Vec3f to) const {
        bool found = false;
        forEachCube({from, to}, [&](const Cube& cube) {
            const auto triangles = cubes_.find(cube);
            if (found || triangles == cubes_.end()) return;
            found = std::any_of(triangles->second.begin(), triangles->second.end(),
                                [&](std::uint32_t i) { return cuts(i, from, to); });
        });
        return found;
    }

    // Moeller and Trumbore 1997.
    bool cuts(std::uint32_t triangle, Vec3f from, Vec3f to) const {
        const auto& [ia, ib, ic] = mesh_.triangles[triangle];
        const Vec3d a = mesh_.vertices[ia].as<double>();
        const Vec3d ab = mesh_.vertices[ib].as<double>() - a;
        const Vec3d ac = mesh_.vertices[ic].as<double>() - a;
        const Vec3d origin = from.as<double>();
        const Vec3d direction = to.as<double>() - origin;
        const Vec3d across = cross(direction, ac);
        const double determinant = dot(ab, across);
        if (determinant == 0) return false;
        const double u = dot(origin - a, across) / determinant;
        const Vec3d turned = cross(origin - a, ab);
        const double v = dot(direction, turned) / determinant;
        const double t = dot(ac, turned) / determinant;
        return u >= 0 && v >= 0 && u + v <= 1 && t >= 0 && t <= 1;
    }

    const Mesh& mesh_;
    std::map<Cube, std::vector<std::uint32_t>> cubes_;
};

}  // namespace kushi::test
