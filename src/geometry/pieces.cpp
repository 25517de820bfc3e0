// SPDX-License-Identifier: Apache-2.0
#include "geometry/pieces.h"

#include <algorithm>
#include <tuple>

namespace kushi {
namespace {

constexpr std::uint32_t nobody = 0xffffffffU;

/// One side of a triangle, from corner `corner` to the next.
struct Side {
    std::uint32_t low, high;  ///< its vertices
    std::uint32_t triangle;
    std::uint32_t corner;
    bool rising;  ///< whether it runs from `low` to `high`
};

struct Neighbour {
    std::uint32_t triangle = nobody;
    bool alike = true;  ///< whether both face one way
};

std::vector<Side> sidesOf(std::span<const Corners> triangles) {
    std::vector<Side> sides;
    sides.reserve(3 * triangles.size());
    for (std::uint32_t t = 0; t < triangles.size(); ++t) {
        for (std::uint32_t k = 0; k < 3; ++k) {
            const std::uint32_t from = triangles[t][k], to = triangles[t][(k + 1) % 3];
            sides.push_back({std::min(from, to), std::max(from, to), t, k, from < to});
        }
    }
    std::ranges::sort(sides, {}, [](const Side& side) {
        return std::tuple(side.low, side.high, side.triangle, side.corner);
    });
    return sides;
}

std::vector<std::array<Neighbour, 3>> neighboursOf(std::span<const Corners> triangles) {
    const std::vector<Side> sides = sidesOf(triangles);
    std::vector<std::array<Neighbour, 3>> neighbours(triangles.size());
    for (std::size_t i = 0, end = 0; i < sides.size(); i = end) {
        while (end < sides.size() && sides[end].low == sides[i].low &&
               sides[end].high == sides[i].high)
            ++end;
        if (end - i != 2) continue;
        const Side &a = sides[i], &b = sides[i + 1];
        const bool alike = a.rising != b.rising;
        neighbours[a.triangle][a.corner] = {b.triangle, alike};
        neighbours[b.triangle][b.corner] = {a.triangle, alike};
    }
    return neighbours;
}

}  // namespace

std::vector<std::vector<Corners>> piecesOf(std::span<const Corners> triangles) {
    const auto neighbours = neighboursOf(triangles);
    enum class Turn : std::uint8_t { Unknown, AsItIs, Around };
    std::vector<Turn> turns(triangles.size(), Turn::Unknown);
    std::vector<std::vector<Corners>> pieces;
    std::vector<std::uint32_t> open;
    for (std::uint32_t start = 0; start < triangles.size(); ++start) {
        if (turns[start] != Turn::Unknown) continue;
        turns[start] = Turn::AsItIs;
        open = {start};
        std::vector<Corners>& piece = pieces.emplace_back();
        while (!open.empty()) {
            const std::uint32_t t = open.back();
            open.pop_back();
            const auto& [a, b, c] = triangles[t];
            piece.push_back(turns[t] == Turn::AsItIs ? Corners{a, b, c} : Corners{a, c, b});
            for (const Neighbour& next : neighbours[t]) {
                if (next.triangle == nobody || turns[next.triangle] != Turn::Unknown) continue;
                const bool asItIs = (turns[t] == Turn::AsItIs) == next.alike;
                turns[next.triangle] = asItIs ? Turn::AsItIs : Turn::Around;
                open.push_back(next.triangle);
            }
        }
    }
    return pieces;
}

}  // namespace kushi
