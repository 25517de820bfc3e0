// SPDX-License-Identifier: Apache-2.0
#include "head/refine.h"

#include "core/parallel.h"
#include "head/edges.h"
#include "head/flip.h"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <utility>

namespace kushi {

namespace {

class Refinement {
public:
    Refinement(const Field& field, const Fineness& fineness, HalfSurface& half)
        : field_(field), fineness_(fineness), half_(half) {
        measureNormals(0);
    }

    /// One round; false when nothing was left to split.
    bool split() {
        const Edges edges(half_.triangles);
        mark(edges);
        close(edges);
        const std::size_t before = half_.points.size();
        std::vector<std::uint32_t> middles(edges.size(), 0);
        for (std::size_t e = 0; e < edges.size(); ++e) {
            if (marked_[e] != 0) middles[e] = addMiddle(edges.ends(e));
        }
        if (half_.points.size() == before) return false;
        project(before);
        measureNormals(before);
        std::vector<Triangle> triangles;
        for (std::size_t t = 0; t < half_.triangles.size(); ++t) {
            divide(edges, middles, t, triangles);
        }
        half_.triangles = std::move(triangles);
        return true;
    }

    void measureNormals(std::size_t first) {
        normals_.resize(half_.points.size());
        parallelFor(half_.points.size() - first, 256, 0, [&](std::size_t begin, std::size_t end) {
            for (std::size_t i = first + begin; i < first + end; ++i) {
                normals_[i] = fieldNormal(field_, half_.points[i], 0.02);
            }
        });
    }

    const std::vector<Vec3d>& normals() const { return normals_; }

private:
    double edgeLength(std::pair<std::uint32_t, std::uint32_t> ends) const {
        return length(half_.points[ends.first] - half_.points[ends.second]);
    }

    bool tooCoarse(std::pair<std::uint32_t, std::uint32_t> ends) const {
        const Vec3d middle = 0.5 * (half_.points[ends.first] + half_.points[ends.second]);
        if (edgeLength(ends) < 2 * fineness_.minEdge(middle)) return false;
        if (length(normals_[ends.first] - normals_[ends.second]) > fineness_.maxTurn) return true;
        return std::abs(field_(middle)) > fineness_.maxError;
    }

    void mark(const Edges& edges) {
        marked_.assign(edges.size(), 0);
        parallelFor(edges.size(), 512, 0, [&](std::size_t begin, std::size_t end) {
            for (std::size_t e = begin; e < end; ++e)
                marked_[e] = tooCoarse(edges.ends(e)) ? 1 : 0;
        });
    }

    std::size_t longest(const Edges& edges, std::size_t triangle) const {
        const Triangle& own = edges.ofTriangle(triangle);
        std::size_t best = 0;
        for (std::size_t c = 1; c < 3; ++c) {
            if (edgeLength(edges.ends(own[c])) > edgeLength(edges.ends(own[best]))) best = c;
        }
        return best;
    }

    // A triangle that is split at all is split at its longest edge: no ever thinner slivers.
    void close(const Edges& edges) {
        for (bool changed = true; changed;) {
            changed = false;
            for (std::size_t t = 0; t < half_.triangles.size(); ++t) {
                const Triangle& own = edges.ofTriangle(t);
                if (marked_[own[0]] + marked_[own[1]] + marked_[own[2]] == 0) continue;
                std::uint8_t& mark = marked_[own[longest(edges, t)]];
                changed = changed || mark == 0;
                mark = 1;
            }
        }
    }

    std::uint32_t addMiddle(std::pair<std::uint32_t, std::uint32_t> ends) {
        half_.points.push_back(0.5 * (half_.points[ends.first] + half_.points[ends.second]));
        const bool onPlane = half_.onPlane[ends.first] != 0 && half_.onPlane[ends.second] != 0;
        half_.onPlane.push_back(onPlane ? 1 : 0);
        return static_cast<std::uint32_t>(half_.points.size() - 1);
    }

    void project(std::size_t first) {
        parallelFor(half_.points.size() - first, 256, 0, [&](std::size_t begin, std::size_t end) {
            for (std::size_t i = first + begin; i < first + end; ++i) {
                half_.points[i] = ontoSurface(field_, half_.points[i], half_.onPlane[i] != 0, 1);
            }
        });
    }

    void divide(const Edges& edges, const std::vector<std::uint32_t>& middles, std::size_t t,
                std::vector<Triangle>& into) const {
        const Triangle& own = edges.ofTriangle(t);
        const int splits = marked_[own[0]] + marked_[own[1]] + marked_[own[2]];
        if (splits == 0) {
            into.push_back(half_.triangles[t]);
            return;
        }
        // Turned so that the longest edge is a-b.
        const std::size_t turn = longest(edges, t);
        const auto corner = [&](std::size_t c) { return half_.triangles[t][(turn + c) % 3]; };
        const auto edge = [&](std::size_t c) { return own[(turn + c) % 3]; };
        const auto [a, b, c] = std::array{corner(0), corner(1), corner(2)};
        const auto [ab, bc, ca] = std::array{middles[edge(0)], middles[edge(1)], middles[edge(2)]};
        const bool second = marked_[edge(1)] != 0;
        const bool third = marked_[edge(2)] != 0;
        if (second) {
            into.push_back({ab, b, bc});
            into.push_back({ab, bc, c});
        } else {
            into.push_back({ab, b, c});
        }
        if (third) {
            into.push_back({a, ab, ca});
            into.push_back({ab, c, ca});
        } else {
            into.push_back({a, ab, c});
        }
    }

    const Field& field_;
    const Fineness& fineness_;
    HalfSurface& half_;
    std::vector<Vec3d> normals_;
    std::vector<std::uint8_t> marked_;
};

/// Moves every vertex towards the middle of its neighbours and back onto the surface.
void evenOut(const Field& field, HalfSurface& half) {
    std::vector<Vec3d> sums(half.points.size());
    std::vector<int> counts(half.points.size(), 0);
    const auto link = [&](std::uint32_t a, std::uint32_t b) {
        // On the plane of symmetry the other half's neighbours cancel what leads away from it.
        if (half.onPlane[a] != 0 && half.onPlane[b] == 0) return;
        sums[a] += half.points[b];
        ++counts[a];
    };
    for (const auto& [a, b, c] : half.triangles) {
        for (const auto& [one, other] : {std::pair{a, b}, std::pair{b, c}, std::pair{c, a}}) {
            link(one, other);
            link(other, one);
        }
    }
    parallelFor(half.points.size(), 256, 0, [&](std::size_t begin, std::size_t end) {
        for (std::size_t i = begin; i < end; ++i) {
            Vec3d& p = half.points[i];
            p = 0.6 * p + 0.4 / counts[i] * sums[i];
            p = ontoSurface(field, p, half.onPlane[i] != 0, 2);
        }
    });
}

}  // namespace

void refine(const Field& field, const Fineness& fineness, HalfSurface& half) {
    evenOut(field, half);
    Refinement refinement(field, fineness, half);
    for (int round = 0; round < fineness.rounds && refinement.split(); ++round) {
    }
    for (int pass = 0; pass < 2; ++pass) {
        flipAcrossCreases(refinement.normals(), half);
        evenOut(field, half);
        refinement.measureNormals(0);
    }
    flipAcrossCreases(refinement.normals(), half);
}

Mesh mirrored(const Field& field, const Fineness& fineness, const HalfSurface& half) {
    const auto count = static_cast<std::uint32_t>(half.points.size());
    std::vector<std::uint32_t> image(count);
    std::uint32_t next = count;
    for (std::uint32_t i = 0; i < count; ++i)
        image[i] = half.onPlane[i] != 0 ? i : next++;

    Mesh mesh;
    mesh.vertices.resize(next);
    mesh.normals.resize(next);
    parallelFor(count, 256, 0, [&](std::size_t begin, std::size_t end) {
        for (std::size_t i = begin; i < end; ++i) {
            const Vec3d at = half.points[i];
            Vec3d normal = fieldNormal(field, at, 0.5 * fineness.minEdge(at));
            if (half.onPlane[i] != 0) normal.z = 0;
            const Vec3f p = at.as<float>();
            const Vec3f n = normalized(normal).as<float>();
            mesh.vertices[image[i]] = {p.x, p.y, -p.z};
            mesh.normals[image[i]] = {n.x, n.y, -n.z};
            mesh.vertices[i] = p;
            mesh.normals[i] = n;
        }
    });
    for (const auto& [a, b, c] : half.triangles) {
        mesh.triangles.push_back({a, b, c});
        mesh.triangles.push_back({image[a], image[c], image[b]});
    }
    return mesh;
}

}  // namespace kushi
