// SPDX-License-Identifier: Apache-2.0
#include "geometry/triangle_tree.h"

#include <numbers>

namespace kushi {
namespace {

/// A node counts as a dipole from so many of its radii on.
constexpr double farInRadii = 2;

double solidAngleOf(const TriangleTree& tree, std::uint32_t index, Vec3d place) {
    const TriangleTree::Node& node = tree.nodes[index];
    const Vec3d way = node.middle.as<double>() - place;
    const double square = dot(way, way);
    const double near = farInRadii * static_cast<double>(node.radius);
    if (square > near * near)
        return dot(node.area.as<double>(), way) / (square * std::sqrt(square));
    if (node.right != 0) {
        return solidAngleOf(tree, index + 1, place) + solidAngleOf(tree, node.right, place);
    }
    double sum = 0;
    for (std::uint32_t i = node.first; i < node.first + node.count; ++i)
        sum += solidAngle(place, tree.triangles[i]);
    return sum;
}

double exactSolidAngle(const TriangleTree& tree, Vec3d place) {
    double sum = 0;
    for (const Triangle& triangle : tree.triangles)
        sum += solidAngle(place, triangle);
    return sum;
}

}  // namespace

double windingNumber(const TriangleTree& tree, Vec3d place) {
    if (tree.nodes.empty()) return 0;
    constexpr double turn = 4 * std::numbers::pi;
    constexpr double doubt = 0.25;
    const double quick = solidAngleOf(tree, 0, place) / turn;
    return std::abs(quick - 0.5) > doubt ? quick : exactSolidAngle(tree, place) / turn;
}

}  // namespace kushi
