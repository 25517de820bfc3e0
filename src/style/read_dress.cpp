// SPDX-License-Identifier: Apache-2.0
#include "style/number_or_table.h"
#include "style/read_parts.h"

namespace kushi {

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
