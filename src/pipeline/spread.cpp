// SPDX-License-Identifier: Apache-2.0
#include "pipeline/spread.h"

#include <kushi/strands.h>

#include <algorithm>
#include <numeric>

namespace kushi {

namespace {

constexpr int bitsPerAxis = 21;

// The bits of three numbers by turns.
std::uint64_t interleaved(Vec3f inUnitCube) {
    std::uint64_t code = 0;
    const auto cell = [](float x) {
        return static_cast<std::uint64_t>(x * static_cast<float>((1U << bitsPerAxis) - 1));
    };
    const std::uint64_t axes[] = {cell(inUnitCube.x), cell(inUnitCube.y), cell(inUnitCube.z)};
    for (unsigned bit = 0; bit < bitsPerAxis; ++bit) {
        for (unsigned axis = 0; axis < 3; ++axis)
            code |= (axes[axis] >> bit & 1U) << (3 * bit + axis);
    }
    return code;
}

std::vector<std::uint64_t> mortonCodes(std::span<const Vec3f> points) {
    const Bounds bounds = boundsOf(points);
    const Vec3f size = bounds.high - bounds.low;
    const float side = std::max({size.x, size.y, size.z});
    std::vector<std::uint64_t> codes;
    for (const Vec3f point : points)
        codes.push_back(side > 0 ? interleaved((point - bounds.low) / side) : 0);
    return codes;
}

std::uint32_t reversed(std::uint32_t bits) {
    std::uint32_t result = 0;
    for (unsigned bit = 0; bit < 32; ++bit)
        result |= (bits >> bit & 1U) << (31 - bit);
    return result;
}

}  // namespace

std::vector<std::uint32_t> spreadSubset(std::span<const Vec3f> points, std::size_t count) {
    std::vector<std::uint32_t> along(points.size());
    std::iota(along.begin(), along.end(), 0U);
    if (count >= points.size()) return along;
    const std::vector<std::uint64_t> codes = mortonCodes(points);
    std::stable_sort(along.begin(), along.end(),
                     [&](std::uint32_t a, std::uint32_t b) { return codes[a] < codes[b]; });

    std::vector<std::uint32_t> ranks(points.size());
    std::iota(ranks.begin(), ranks.end(), 0U);
    std::sort(ranks.begin(), ranks.end(),
              [](std::uint32_t a, std::uint32_t b) { return reversed(a) < reversed(b); });
    std::vector<std::uint32_t> taken;
    for (std::size_t k = 0; k < count; ++k)
        taken.push_back(along[ranks[k]]);
    std::sort(taken.begin(), taken.end());
    return taken;
}

}  // namespace kushi
