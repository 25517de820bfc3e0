// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "style/source_check.h"

#include <optional>
#include <string_view>

namespace kushi {

/// How many parts a dotted key may have.
inline constexpr int longestKeyPath = 32;

/// Looks through the tokens of UTF-8 text for what the TOML parser does not bear:
///
/// - dotted keys of more than `longestKeyPath` parts, as the tables that they make nest that deep;
/// - characters beyond ASCII where none belong (outside of strings and comments), about which it
///   asks whether they are blanks, a question it answers for some only. The same goes for what
///   follows a backslash in a multi-line string, and for strings stuck to a bare word.
std::optional<SourceFault> findLexicalFault(std::string_view text);

}  // namespace kushi
