// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstddef>
#include <optional>
#include <string>
#include <string_view>
#include <variant>
#include <vector>

namespace kushi {

/// A key of a table, or an index into an array.
using Step = std::variant<std::string, std::size_t>;

/// "part[0].force[2].magnitude" as part, 0, force, 2, magnitude; nothing if it is not of that form.
/// Names are bare keys (letters, digits, '_' and '-').
std::optional<std::vector<Step>> parseKeyPath(std::string_view path);

/// The reverse.
std::string toString(const std::vector<Step>& path);

}  // namespace kushi
