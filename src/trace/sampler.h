// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "core/random.h"

#include <cstdint>

namespace kushi {

constexpr std::uint32_t reversedBits(std::uint32_t x) {
    x = ((x >> 1U) & 0x55555555U) | ((x & 0x55555555U) << 1U);
    x = ((x >> 2U) & 0x33333333U) | ((x & 0x33333333U) << 2U);
    x = ((x >> 4U) & 0x0f0f0f0fU) | ((x & 0x0f0f0f0fU) << 4U);
    return __builtin_bswap32(x);
}

/// Scrambles a number whose bits stand in reverse: each bit is flipped or not depending on those
/// below it (Laine and Karras 2011).
constexpr std::uint32_t scrambleUpwards(std::uint32_t x, std::uint32_t seed) {
    x += seed;
    x ^= x * 0x6c50b47cU;
    x ^= x * 0xb82f1e52U;
    x ^= x * 0xc7afe638U;
    x ^= x * 0x8d22f6e6U;
    return x;
}

/// Second coordinate of Sobol's sequence, as its bits in reverse: the index times Pascal's triangle
/// modulo two, an entry of which is odd where one index's bits are among the other's.
constexpr std::uint32_t sobolReversed(std::uint32_t index) {
    index ^= (index & 0xaaaaaaaaU) >> 1U;
    index ^= (index & 0xccccccccU) >> 2U;
    index ^= (index & 0xf0f0f0f0U) >> 4U;
    index ^= (index & 0xff00ff00U) >> 8U;
    index ^= index >> 16U;
    return index;
}

/// Two numbers in [0, 1).
struct Pair {
    float u = 0, v = 0;
};

/// The random numbers of one sample of one pixel, in pairs. Over the samples of a pixel each pair
/// is a (0, 2)-sequence of its own, so that 2^k samples are evenly spread over the unit square:
/// Sobol's first two coordinates, Owen-scrambled, in an Owen-scrambled order (Burley 2020).
class Sampler {
public:
    Sampler(std::uint64_t pixelKey, std::uint32_t sample) : key_(pixelKey), sample_(sample) {}

    Pair pair() {
        const std::uint64_t seeds = mixKey(key_, dimension_++);
        const std::uint64_t more = scramble(seeds);
        const std::uint32_t index =
            reversedBits(scrambleUpwards(reversedBits(sample_), static_cast<std::uint32_t>(seeds)));
        // The first coordinate's bits in reverse are the index itself.
        return {fraction(scrambleUpwards(index, static_cast<std::uint32_t>(seeds >> 32U))),
                fraction(scrambleUpwards(sobolReversed(index), static_cast<std::uint32_t>(more)))};
    }

    /// One number in [0, 1), spread by chance alone.
    float single() {
        const std::uint64_t key = mixKey(mixKey(key_, dimension_++), sample_);
        return static_cast<float>(key >> 40U) * 0x1p-24F;
    }

private:
    static float fraction(std::uint32_t reversed) {
        return static_cast<float>(reversedBits(reversed) >> 8U) * 0x1p-24F;
    }

    std::uint64_t key_;
    std::uint32_t sample_;
    std::uint64_t dimension_ = 0;
};

}  // namespace kushi
