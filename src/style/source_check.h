// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstddef>
#include <optional>
#include <string>
#include <string_view>

namespace kushi {

/// The longest style that is read: 4 MiB, some thousand times what people write.
inline constexpr std::size_t longestStyle = std::size_t{4} << 20U;

/// Why a text is no TOML document at all, and where.
struct SourceFault {
    std::optional<std::size_t> offset;  ///< none if it concerns the whole
    std::string message;
};

/// Looks for what must not reach a parser: too much text, bytes that are not UTF-8, zero bytes, and
/// what findLexicalFault() finds.
std::optional<SourceFault> findSourceFault(std::string_view text);

}  // namespace kushi
