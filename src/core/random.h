// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <string_view>

namespace kushi {

/// Scrambles 64 bits into 64 bits, each depending on all (the finaliser of SplitMix64; Steele, Lea
/// and Flood 2014).
constexpr std::uint64_t scramble(std::uint64_t x) {
    x += 0x9e3779b97f4a7c15U;
    x = (x ^ (x >> 30U)) * 0xbf58476d1ce4e5b9U;
    x = (x ^ (x >> 27U)) * 0x94d049bb133111ebU;
    return x ^ (x >> 31U);
}

/// A key made of a key and one more number. Random numbers in Kushi are functions of a key (the
/// follicle's) and of what they are for, never of an index or of the order of evaluation.
constexpr std::uint64_t mixKey(std::uint64_t key, std::uint64_t salt) {
    return scramble(key ^ scramble(salt));
}

/// The key of a text (FNV-1a).
constexpr std::uint64_t textKey(std::string_view text) {
    std::uint64_t hash = 0xcbf29ce484222325U;
    for (const char c : text)
        hash = (hash ^ static_cast<unsigned char>(c)) * 0x100000001b3U;
    return hash;
}

/// Uniform in [0, 1).
constexpr double uniform(std::uint64_t key) {
    return static_cast<double>(scramble(key) >> 11U) * 0x1p-53;
}

/// Uniform in [-1, 1).
constexpr double uniformSigned(std::uint64_t key) {
    return 2 * uniform(key) - 1;
}

}  // namespace kushi
