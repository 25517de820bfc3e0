// SPDX-License-Identifier: Apache-2.0
#include "pipeline/cut.h"

#include "core/random.h"

#include <algorithm>

namespace kushi {

namespace {

constexpr std::uint64_t cutSalt = 0x637574;

// Length of the strand up to where it first passes below a height.
std::optional<double> lengthAbove(double height, std::span<const Vec3d> nodes) {
    if (nodes[0].y < height) return 0.0;
    double walked = 0;
    for (std::size_t i = 1; i < nodes.size(); ++i) {
        const Vec3d from = nodes[i - 1];
        const Vec3d to = nodes[i];
        const double step = length(to - from);
        if (to.y < height) return walked + step * (from.y - height) / (from.y - to.y);
        walked += step;
    }
    return std::nullopt;
}

double wholeLength(std::span<const Vec3d> nodes) {
    double whole = 0;
    for (std::size_t i = 1; i < nodes.size(); ++i)
        whole += length(nodes[i] - nodes[i - 1]);
    return whole;
}

double lengthKeptAt(const std::vector<Cut::Keep>& keep, double y) {
    const auto above =
        std::find_if(keep.begin(), keep.end(), [y](const Cut::Keep& pair) { return pair.y >= y; });
    if (above == keep.begin()) return keep.front().length;
    if (above == keep.end()) return keep.back().length;
    const Cut::Keep& below = *(above - 1);
    const double share = (y - below.y) / (above->y - below.y);
    return below.length + share * (above->length - below.length);
}

}  // namespace

double cutPlace(std::uint64_t key) {
    return uniformSigned(mixKey(key, cutSalt));
}

std::optional<double> lengthLeft(const Cut& cut, std::span<const Vec3d> nodes, double at) {
    const double shift = at * cut.falloff.distance / 2;
    if (cut.below) return lengthAbove(*cut.below - shift, nodes);
    const double kept = std::max(0.0, lengthKeptAt(cut.keep, nodes[0].y) + shift);
    return kept < wholeLength(nodes) ? std::optional(kept) : std::nullopt;
}

std::optional<double> lengthLeft(const Cut& cut, std::span<const Vec3d> nodes, double at,
                                 double share) {
    const auto left = lengthLeft(cut, nodes, at);
    if (!left || share >= 1) return left;
    return share * *left + (1 - share) * wholeLength(nodes);
}

std::vector<Vec3d> clipped(std::span<const Vec3d> nodes, double length) {
    std::vector<Vec3d> part = {nodes[0]};
    for (std::size_t i = 1; i < nodes.size(); ++i) {
        const Vec3d step = nodes[i] - nodes[i - 1];
        const double size = kushi::length(step);
        if (size >= length) {
            if (length > 0) part.push_back(nodes[i - 1] + (length / size) * step);
            break;
        }
        part.push_back(nodes[i]);
        length -= size;
    }
    return part;
}

}  // namespace kushi
