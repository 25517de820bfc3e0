// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "geometry/triangle_tree.h"

#include <cmath>
#include <cstdint>

namespace kushi {

/// Four numbers that the processor treats at once (GCC and Clang).
using Four = float __attribute__((vector_size(16)));

inline Four roots(Four a) {
    return Four{std::sqrt(a[0]), std::sqrt(a[1]), std::sqrt(a[2]), std::sqrt(a[3])};
}

/// Four places beside each other.
struct FourPlaces {
    Four x, y, z;
};

/// How far four places are from the triangles of a tree, which takes little longer than for one.
/// `guess` is a triangle near them, and becomes a nearer one.
Four fourDistances(const TriangleTree& tree, const FourPlaces& places, std::uint32_t& guess);

}  // namespace kushi
