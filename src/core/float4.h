// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>

namespace kushi {

/// Four floats at once, in a register of every x86-64 and arm64; the same results on all of them.
using Float4 = float __attribute__((vector_size(16)));
using Int4 = std::int32_t __attribute__((vector_size(16)));

inline Float4 float4(float x) {
    return Float4{x, x, x, x};
}

inline Float4 smaller(Float4 a, Float4 b) {
    return a < b ? a : b;
}
inline Float4 larger(Float4 a, Float4 b) {
    return a > b ? a : b;
}

/// Towards 0; in the range of Int4.
inline Int4 truncated(Float4 a) {
    return __builtin_convertvector(a, Int4);
}

}  // namespace kushi
