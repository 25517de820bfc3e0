// SPDX-License-Identifier: Apache-2.0
#include "geometry/triangle_tree.h"

#include <span>

namespace kushi {
namespace {

constexpr std::size_t leafSize = 4;

Vec3f middleOf(const Triangle& triangle) {
    return (triangle[0] + triangle[1] + triangle[2]) / 3.0F;
}

Vec3f least(Vec3f a, Vec3f b) {
    return {std::min(a.x, b.x), std::min(a.y, b.y), std::min(a.z, b.z)};
}
Vec3f most(Vec3f a, Vec3f b) {
    return {std::max(a.x, b.x), std::max(a.y, b.y), std::max(a.z, b.z)};
}

float Vec3f::*longestSide(Vec3f size) {
    if (size.x >= size.y && size.x >= size.z) return &Vec3f::x;
    return size.y >= size.z ? &Vec3f::y : &Vec3f::z;
}

TriangleTree::Node nodeAround(std::span<const Triangle> triangles) {
    TriangleTree::Node node;
    node.low = node.high = triangles.front().front();
    Vec3d middle, area;
    double weight = 0;
    for (const Triangle& triangle : triangles) {
        for (const Vec3f corner : triangle) {
            node.low = least(node.low, corner);
            node.high = most(node.high, corner);
        }
        const Vec3d a = triangle[0].as<double>();
        const Vec3d own = 0.5 * cross(triangle[1].as<double>() - a, triangle[2].as<double>() - a);
        area += own;
        middle += length(own) * middleOf(triangle).as<double>();
        weight += length(own);
    }
    node.area = area.as<float>();
    node.middle = weight > 0 ? (middle / weight).as<float>() : 0.5F * (node.low + node.high);
    for (const Triangle& triangle : triangles) {
        for (const Vec3f corner : triangle)
            node.radius = std::max(node.radius, length(corner - node.middle));
    }
    return node;
}

void addNode(TriangleTree& tree, std::size_t first, std::size_t count) {
    const std::span<Triangle> own = std::span(tree.triangles).subspan(first, count);
    TriangleTree::Node node = nodeAround(own);
    node.first = static_cast<std::uint32_t>(first);
    node.count = static_cast<std::uint32_t>(count);
    const std::size_t index = tree.nodes.size();
    tree.nodes.push_back(node);
    if (count <= leafSize) return;

    const auto side = longestSide(node.high - node.low);
    const std::size_t half = count / 2;
    std::nth_element(own.begin(), own.begin() + static_cast<std::ptrdiff_t>(half), own.end(),
                     [side](const Triangle& a, const Triangle& b) {
                         return middleOf(a).*side < middleOf(b).*side;
                     });
    addNode(tree, first, half);
    tree.nodes[index].right = static_cast<std::uint32_t>(tree.nodes.size());
    addNode(tree, first + half, count - half);
}

/// The square of the distance between a place and a node's box.
float squareTo(const TriangleTree::Node& node, Vec3f place) {
    const Vec3f out = most(most(node.low - place, place - node.high), Vec3f{});
    return dot(out, out);
}

}  // namespace

TriangleTree treeOf(std::vector<Triangle> triangles) {
    TriangleTree tree;
    tree.triangles = std::move(triangles);
    if (!tree.triangles.empty()) addNode(tree, 0, tree.triangles.size());
    return tree;
}

Nearest nearestIn(const TriangleTree& tree, Vec3f place, std::uint32_t guess) {
    Nearest best;
    float square = 0;
    const auto consider = [&](std::uint32_t index, bool first) {
        const Vec3f point = closestOnTriangle(place, tree.triangles[index]);
        const Vec3f way = place - point;
        if (!first && dot(way, way) >= square) return;
        square = dot(way, way);
        best = {index, point, 0};
    };
    consider(guess, true);

    struct Entry {
        std::uint32_t node;
        float square;
    };
    std::array<Entry, 64> stack;
    std::size_t size = 0;
    stack[size++] = {0, squareTo(tree.nodes[0], place)};
    while (size > 0) {
        auto [index, away] = stack[--size];
        if (away >= square) continue;
        const TriangleTree::Node* node = &tree.nodes[index];
        while (node->right != 0) {
            std::uint32_t near = index + 1, far = node->right;
            float toNear = squareTo(tree.nodes[near], place);
            float toFar = squareTo(tree.nodes[far], place);
            if (toFar < toNear) {
                std::swap(near, far);
                std::swap(toNear, toFar);
            }
            if (toFar < square) stack[size++] = {far, toFar};
            if (toNear >= square) break;
            index = near;
            node = &tree.nodes[index];
        }
        if (node->right != 0) continue;
        for (std::uint32_t i = node->first; i < node->first + node->count; ++i)
            consider(i, false);
    }
    best.distance = std::sqrt(square);
    return best;
}

}  // namespace kushi
