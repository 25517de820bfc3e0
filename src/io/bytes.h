// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <bit>
#include <cstring>
#include <string>

namespace kushi {

// The binary formats are little-endian, and so is every machine Kushi is built for.
static_assert(std::endian::native == std::endian::little);

/// The number that starts at `bytes`, at any alignment.
template <class T>
T load(const char* bytes) {
    T value;
    std::memcpy(&value, bytes, sizeof(T));
    return value;
}

/// Appends the bytes of a number.
template <class T>
void store(std::string& out, T value) {
    const std::size_t end = out.size();
    out.resize(end + sizeof(T));
    std::memcpy(out.data() + end, &value, sizeof(T));
}

}  // namespace kushi
