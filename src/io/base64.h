// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <optional>
#include <string>
#include <string_view>

namespace kushi {

/// The bytes that base64 spells (RFC 4648); nothing if it is none.
std::optional<std::string> decodeBase64(std::string_view text);

/// A URI's path with its %20 and the like decoded; nothing if one of them is malformed.
std::optional<std::string> decodePercent(std::string_view text);

}  // namespace kushi
