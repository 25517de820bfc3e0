// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "style/table_reader.h"

#include <kushi/style.h>

namespace kushi {

inline constexpr const char* expectedDirection = "a name as in \"z\" or a vector as in [0, 1, 0]";

/// A direction by name or as three numbers; `reversed` is set where the name's is the other way
/// round.
void readDirection(const TableReader& table, std::string_view key, ForceDirection& direction,
                   bool& reversed);

}  // namespace kushi
