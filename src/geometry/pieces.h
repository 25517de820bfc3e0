// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <array>
#include <cstdint>
#include <span>
#include <vector>

namespace kushi {

/// Three different vertices, counter-clockwise seen from outside.
using Corners = std::array<std::uint32_t, 3>;

/// The connected pieces of triangles, each made to face one way: triangles are neighbours where an
/// edge belongs to the two of them alone. A piece with one side only (a Moebius strip) keeps a line
/// of edges along which it does not agree.
std::vector<std::vector<Corners>> piecesOf(std::span<const Corners> triangles);

}  // namespace kushi
