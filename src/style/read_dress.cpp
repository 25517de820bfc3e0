// SPDX-License-Identifier: Apache-2.0
#include "style/read_number.h"
#include "style/read_parts.h"

namespace kushi {

namespace {

// The number that matters most, alone; or a table of it and others.
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

}  // namespace

void readDress(const TableReader& table, Hair& hair) {
    const auto readClump = [&](const Node& node) {
        const TableReader reader(node, tables::clump, table.context());
        reader.require("amount", expectedNumber(quantities::clump));
        reader.number("amount", quantities::clump, hair.clump.amount);
        reader.number("size", quantities::clumpSize, hair.clump.size);
        reader.number("variation", quantities::variation, hair.clump.variation);
        reader.number("from", quantities::clumpFrom, hair.clump.from);
    };
    readNumberOrTable(table, "clump", quantities::clump, "{ amount = 0.3, size = 0.8 }",
                      hair.clump.amount, readClump);
    const auto readFlyaway = [&](const Node& node) {
        const TableReader reader(node, tables::flyaway, table.context());
        reader.require("share", expectedNumber(quantities::flyawayShare));
        reader.number("share", quantities::flyawayShare, hair.flyaway.share);
        reader.number("distance", quantities::flyawayDistance, hair.flyaway.distance);
    };
    readNumberOrTable(table, "flyaway", quantities::flyawayShare, "{ share = 0.015, distance = 1 }",
                      hair.flyaway.share, readFlyaway);
}

}  // namespace kushi
