// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "core/random.h"
#include "io/bytes.h"

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
        while (bytes.size() >= sizeof(std::uint64_t)) {
            add(load<std::uint64_t>(bytes.data()));
            bytes.remove_prefix(sizeof(std::uint64_t));
        }
        std::uint64_t rest = 0;
        std::memcpy(&rest, bytes.data(), bytes.size());
        add(rest);
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
