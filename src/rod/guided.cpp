// SPDX-License-Identifier: Apache-2.0
#include "rod/guided.h"

#include <algorithm>

namespace kushi {

namespace {

// Of so many one goes first at least.
constexpr std::uint32_t guidesApart = 8;
// How far from another the roots of the two may be, over the strand's length.
constexpr float reach = 0.1F;
constexpr float cellSize = 2e-3F;  // [m]

// The number of a place's cell along a curve through space that seldom goes far at once (G. M.
// Morton, "A computer oriented geodetic data base", IBM 1966).
std::uint32_t cellOf(Vec3f at) {
    constexpr int bits = 10;
    constexpr auto cells = static_cast<float>(1 << bits);
    std::uint32_t cell = 0;
    const float numbers[] = {at.x, at.y, at.z};
    for (int axis = 0; axis < 3; ++axis) {
        // In this order, what is no number becomes 0.
        const float steps =
            std::min(std::max(0.0F, numbers[axis] / cellSize + cells / 2), cells - 1);
        const auto whole = static_cast<std::uint32_t>(steps);
        for (int bit = 0; bit < bits; ++bit)
            cell |= (whole >> bit & 1U) << (3 * bit + axis);
    }
    return cell;
}

}  // namespace

std::uint32_t Guided::apartOf(std::uint32_t i) {
    std::uint32_t apart = 1;
    while (apart < guidesApart && i % (2 * apart) == 0)
        apart *= 2;
    return apart;
}

Guided::Guided(const StrandBatch& batch, std::vector<std::uint32_t> places)
    : places_(std::move(places)), at_(batch.strands.size()), before_(places_.size()) {
    const auto root = [&](std::uint32_t place) { return batch.rods->roots[batch.strands[place]]; };
    std::vector<std::uint32_t> cells(batch.strands.size());
    for (const std::uint32_t place : places_)
        cells[place] = cellOf(root(place));
    std::ranges::stable_sort(places_, {}, [&](std::uint32_t place) { return cells[place]; });

    const auto near = [&](const Between& three) {
        const float most = reach * batch.rods->lengths[batch.strands[three.place]];
        const Vec3f one = root(three.one);
        const Vec3f across = root(three.other) - one;
        const Vec3f way = root(three.place) - one;
        return std::max(dot(across, across), dot(way, way)) <= most * most;
    };
    for (std::uint32_t i = 0; i < places_.size(); ++i) {
        at_[places_[i]] = i;
        const std::uint32_t apart = apartOf(i);
        if (apart < guidesApart && i + apart < places_.size() && near(between(i, apart))) {
            before_[i] = 2;
        } else {
            guides_.push_back(places_[i]);
        }
    }
}

}  // namespace kushi
