// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "style/read_number.h"
#include "style/table_reader.h"

#include <string>

namespace kushi {

/// A key whose value is the number that matters most, alone, or a table of it and others.
///
/// example    such a table, for the problem with what is neither
/// readTable  called with the table's node
template <class ReadTable>
void readNumberOrTable(const TableReader& table, std::string_view key, const Quantity& quantity,
                       const std::string& example, double& number, ReadTable readTable) {
    const Node* node = table.find(key);
    if (node == nullptr) return;
    Diagnostics& problems = table.context().problems;
    if (node->kind == Kind::Table) {
        readTable(*node);
    } else if (node->isNumber() || node->kind == Kind::String) {
        number = readNumber(*node, key, quantity, problems).value_or(number);
    } else {
        problems.unexpected(key, *node, expectedNumber(quantity) + " or a table, as in " + example);
    }
}

}  // namespace kushi
