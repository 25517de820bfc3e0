// SPDX-License-Identifier: Apache-2.0
#include "geometry/four_distances.h"

#include <array>

namespace kushi {
namespace {

Four least(Four a, Four b) {
    return a < b ? a : b;
}
Four most(Four a, Four b) {
    return a > b ? a : b;
}
Four fromZeroToOne(Four a) {
    return least(most(a, Four{}), Four{} + 1.0F);
}
bool anyLess(Four a, Four b) {
    const auto less = a < b;
    return (less[0] | less[1] | less[2] | less[3]) != 0;
}
float sum(Four a) {
    return a[0] + a[1] + a[2] + a[3];
}

FourPlaces minus(const FourPlaces& a, Vec3f b) {
    return {a.x - b.x, a.y - b.y, a.z - b.z};
}
FourPlaces minus(const FourPlaces& a, Four times, Vec3f b) {
    return {a.x - times * b.x, a.y - times * b.y, a.z - times * b.z};
}
Four dot(Vec3f a, const FourPlaces& b) {
    return a.x * b.x + a.y * b.y + a.z * b.z;
}
Four squareOf(const FourPlaces& a) {
    return a.x * a.x + a.y * a.y + a.z * a.z;
}
float inverse(float x) {
    return x > 0 ? 1 / x : 0;
}

/// The squares of the distances to a triangle: those to its sides, and to its plane where the foot
/// of the perpendicular lies within. No branches: the four go different ways.
Four squaresTo(const Triangle& triangle, const FourPlaces& places) {
    const auto& [a, b, c] = triangle;
    const Vec3f ab = b - a, ac = c - a, bc = c - b;
    const float abab = dot(ab, ab), abac = dot(ab, ac), acac = dot(ac, ac), bcbc = dot(bc, bc);
    const FourPlaces way = minus(places, a), wayB = minus(places, b);
    const Four alongAb = dot(ab, way), alongAc = dot(ac, way), alongBc = dot(bc, wayB);
    const Four toAb = squareOf(minus(way, fromZeroToOne(alongAb * inverse(abab)), ab));
    const Four toAc = squareOf(minus(way, fromZeroToOne(alongAc * inverse(acac)), ac));
    const Four toBc = squareOf(minus(wayB, fromZeroToOne(alongBc * inverse(bcbc)), bc));
    const Four toSides = least(least(toAb, toAc), toBc);

    const float perArea = inverse(abab * acac - abac * abac);
    const Four atB = (acac * alongAb - abac * alongAc) * perArea;
    const Four atC = (abab * alongAc - abac * alongAb) * perArea;
    const Four within = least(least(atB, atC), 1 - atB - atC);
    const Four toPlane = squareOf(minus(minus(way, atB, ab), atC, ac));
    return within >= 0 ? least(toPlane, toSides) : toSides;
}

/// The squares of the distances to a node's box.
Four squaresTo(const TriangleTree::Node& node, const FourPlaces& places) {
    const Four x = most(most(node.low.x - places.x, places.x - node.high.x), Four{});
    const Four y = most(most(node.low.y - places.y, places.y - node.high.y), Four{});
    const Four z = most(most(node.low.z - places.z, places.z - node.high.z), Four{});
    return x * x + y * y + z * z;
}

}  // namespace

Four fourDistances(const TriangleTree& tree, const FourPlaces& places, std::uint32_t& guess) {
    Four best = squaresTo(tree.triangles[guess], places);
    struct Entry {
        std::uint32_t node;
        Four squares;
    };
    std::array<Entry, 64> stack;
    std::size_t size = 0;
    stack[size++] = {0, Four{}};
    while (size > 0) {
        const Entry entry = stack[--size];
        if (!anyLess(entry.squares, best)) continue;
        const TriangleTree::Node& node = tree.nodes[entry.node];
        if (node.right != 0) {
            Entry near = {entry.node + 1, squaresTo(tree.nodes[entry.node + 1], places)};
            Entry far = {node.right, squaresTo(tree.nodes[node.right], places)};
            if (sum(far.squares) < sum(near.squares)) std::swap(near, far);
            stack[size++] = far;
            stack[size++] = near;
            continue;
        }
        for (std::uint32_t i = node.first; i < node.first + node.count; ++i) {
            const Four squares = squaresTo(tree.triangles[i], places);
            if (!anyLess(squares, best)) continue;
            guess = i;
            best = least(best, squares);
        }
    }
    return roots(best);
}

}  // namespace kushi
