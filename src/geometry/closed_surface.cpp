// SPDX-License-Identifier: Apache-2.0
#include "geometry/closed_surface.h"

#include "geometry/caps.h"
#include "geometry/pieces.h"

#include <algorithm>
#include <numeric>
#include <tuple>

namespace kushi {
namespace {

/// For each vertex the first one at its place.
std::vector<std::uint32_t> firstAtSamePlace(std::span<const Vec3f> vertices) {
    std::vector<std::uint32_t> order(vertices.size());
    std::iota(order.begin(), order.end(), 0U);
    std::ranges::sort(order, {}, [vertices](std::uint32_t i) {
        return std::tuple(vertices[i].x, vertices[i].y, vertices[i].z, i);
    });
    std::vector<std::uint32_t> first(vertices.size());
    std::uint32_t current = 0;
    for (std::size_t k = 0; k < order.size(); ++k) {
        if (k == 0 || vertices[order[k]] != vertices[current]) current = order[k];
        first[order[k]] = current;
    }
    return first;
}

/// The triangles that have three corners, each once, whichever way it faces.
std::vector<Corners> soundTriangles(const Mesh& mesh) {
    const std::vector<std::uint32_t> first = firstAtSamePlace(mesh.vertices);
    std::vector<Corners> triangles, sorted;
    for (const auto& [i, j, k] : mesh.triangles) {
        const Corners corners = {first[i], first[j], first[k]};
        const auto& [a, b, c] = corners;
        if (a == b || b == c || c == a) continue;
        triangles.push_back(corners);
        std::ranges::sort(sorted.emplace_back(corners));
    }
    std::vector<std::size_t> order(triangles.size());
    std::iota(order.begin(), order.end(), std::size_t{0});
    std::ranges::sort(order, {}, [&sorted](std::size_t i) { return std::pair(sorted[i], i); });
    std::vector<bool> again(triangles.size());
    for (std::size_t k = 1; k < order.size(); ++k)
        again[order[k]] = sorted[order[k]] == sorted[order[k - 1]];
    std::vector<Corners> sound;
    for (std::size_t i = 0; i < triangles.size(); ++i) {
        if (!again[i]) sound.push_back(triangles[i]);
    }
    return sound;
}

/// Six times what closed triangles hold, below 0 if they face inwards.
double sixVolumes(std::span<const Triangle> triangles) {
    const Vec3d origin = triangles.front().front().as<double>();
    double sum = 0;
    for (const auto& [a, b, c] : triangles) {
        sum +=
            dot(a.as<double>() - origin, cross(b.as<double>() - origin, c.as<double>() - origin));
    }
    return sum;
}

}  // namespace

std::vector<Triangle> closedSurface(const Mesh& mesh) {
    std::vector<Triangle> surface;
    for (const std::vector<Corners>& piece : piecesOf(soundTriangles(mesh))) {
        std::vector<Triangle> closed = capsOf(piece, mesh.vertices);
        for (const auto& [a, b, c] : piece)
            closed.push_back({mesh.vertices[a], mesh.vertices[b], mesh.vertices[c]});
        if (sixVolumes(closed) < 0) {
            for (Triangle& triangle : closed)
                std::swap(triangle[1], triangle[2]);
        }
        surface.insert(surface.end(), closed.begin(), closed.end());
    }
    return surface;
}

}  // namespace kushi
