// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <kushi/style.h>

#include <span>
#include <string>
#include <string_view>

namespace kushi {

/// A number for people, to six digits: "0.1", "300", "1e-12".
std::string plainNumber(double value);

/// Names for people: "'a', 'b' or 'c'", with `quote` around each.
std::string listed(std::span<const std::string_view> names, char quote);

/// A value as TOML: floats in the shortest form that reads back exactly, always with a decimal
/// point; strings in double quotes.
std::string spell(const StyleValue& value);

}  // namespace kushi
