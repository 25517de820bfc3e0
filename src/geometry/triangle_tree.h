// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "geometry/triangle.h"

#include <cstdint>
#include <vector>

namespace kushi {

/// Triangles by place: a binary tree, each node split at the median along its longest side.
struct TriangleTree {
    struct Node {
        Vec3f low, high;          ///< the box around its triangles
        Vec3f middle;             ///< of its triangles, weighted by area
        Vec3f area;               ///< the sum of their area vectors
        float radius = 0;         ///< of the ball around `middle` that holds them
        std::uint32_t first = 0;  ///< its triangles
        std::uint32_t count = 0;
        std::uint32_t right = 0;  ///< the second child; the first follows the node; 0: a leaf
    };
    std::vector<Node> nodes;  ///< the root first; empty without triangles
    std::vector<Triangle> triangles;
};

TriangleTree treeOf(std::vector<Triangle> triangles);

/// A triangle of a tree and its point that is nearest to a place.
struct Nearest {
    std::uint32_t triangle = 0;
    Vec3f point;
    float distance = 0;
};

/// What is nearest to a place; the tree has triangles. `guess` is any of them: the nearer it is,
/// the quicker the answer.
Nearest nearestIn(const TriangleTree& tree, Vec3f place, std::uint32_t guess);

/// How often the triangles wind around a place that is not on them: a whole number if they close
/// (Jacobson, Kavan and Sorkine 2013). Nodes that are far off count as dipoles, as in Barill,
/// Dickson, Schmidt, Levin and Jacobson, "Fast Winding Numbers for Soups and Clouds" (2018); where
/// that leaves doubt about a half, all triangles count as they are.
double windingNumber(const TriangleTree& tree, Vec3d place);

}  // namespace kushi
