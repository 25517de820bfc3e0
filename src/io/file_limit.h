// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <kushi/result.h>

#include <cstdint>
#include <string>

namespace kushi {

/// Far above any head: 20 million triangles of binary STL.
inline constexpr std::uint64_t mostBytes = std::uint64_t{1} << 30U;
/// Of the JSON of a glTF file, which takes many times its size in memory.
inline constexpr std::uint64_t mostText = std::uint64_t{1} << 28U;

/// The whole file, if it is a regular one and has at most `most` bytes; asked before any is read.
Result<std::string> readLimitedFile(const std::string& path, std::uint64_t most);

}  // namespace kushi
