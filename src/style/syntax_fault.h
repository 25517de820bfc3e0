// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "style/source_check.h"

#include <cstddef>
#include <string_view>

namespace kushi {

/// What the TOML parser said about `text` at `offset`, put for people and moved to the cause where
/// that is plain: a key given twice, a text value without quotes.
SourceFault syntaxFault(std::string_view description, std::string_view text, std::size_t offset);

}  // namespace kushi
