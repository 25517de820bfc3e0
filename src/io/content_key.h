// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "core/random.h"
#include "io/bytes.h"

#include <algorithm>
#include <array>
#include <cstdint>
#include <span>
#include <string_view>

namespace kushi {

/// A key of contents, made word by word: each word changes all bits that follow (SplitMix64's
/// finaliser). It tells contents apart that differ by chance, not by malice.
class ContentKey {
public:
    explicit ContentKey(std::uint64_t seed) : key_(scramble(seed)) {}

    void add(std::uint64_t word) { key_ = scramble(key_ ^ word); }
    /// The bytes and how many they are.
    void add(std::string_view bytes) {
        add(bytes.size());
        // Four keys side by side: each word waits for the one before it, four words do not.
        std::array<std::uint64_t, 4> keys = {key_, key_ + 1, key_ + 2, key_ + 3};
        constexpr std::size_t step = sizeof(keys);
        while (bytes.size() >= step) {
            const auto words = load<std::array<std::uint64_t, 4>>(bytes.data());
            for (std::size_t i = 0; i < words.size(); ++i)
                keys[i] = scramble(keys[i] ^ words[i]);
            bytes.remove_prefix(step);
        }
        std::array<std::uint64_t, 4> rest{};
        std::copy(bytes.begin(), bytes.end(), reinterpret_cast<char*>(rest.data()));
        for (std::size_t i = 0; i < rest.size(); ++i) {
            add(keys[i]);
            add(rest[i]);
        }
    }
    template <class T>
    void add(std::span<const T> items) {
        add(std::string_view(reinterpret_cast<const char*>(items.data()), items.size_bytes()));
    }

    std::uint64_t value() const { return key_; }

private:
    std::uint64_t key_;
};

}  // namespace kushi
