// SPDX-License-Identifier: Apache-2.0
#include "style/read_direction.h"
#include "style/read_parts.h"

#include <numbers>

namespace kushi {

namespace {

Whorl readWhorl(const Node& node, ReadContext& context) {
    const TableReader table(node, tables::whorl, context);
    Whorl whorl;
    table.require("theta", "a number of degrees, as in theta = 0");
    table.number("theta", quantities::theta, whorl.at.theta);
    table.number("phi", quantities::phi, whorl.at.phi);
    table.number("turn", quantities::turn, whorl.turn);
    return whorl;
}

}  // namespace

void readLean(const TableReader& table, Hair& hair) {
    ReadContext& context = table.context();
    table.number("lift", quantities::lift, hair.lift);
    readDirection(table, "towards", hair.lean.direction, hair.lean.reversed);
    if (const Node* whorl = table.table("whorl", tables::whorl))
        hair.lean.whorl = readWhorl(*whorl, context);
    const Entry* towards = table.node().find("towards");
    const Entry* whorl = table.node().find("whorl");
    if (towards != nullptr && whorl != nullptr) {
        context.problems.add(std::max(towards->at, whorl->at),
                             "found both 'towards' and 'whorl', expected one of them");
    }
    for (const Entry* entry : {towards, whorl}) {
        if (entry == nullptr || table.has("lift")) continue;
        context.problems.add(entry->at, '\'' + entry->key +
                                            "' says where hair leans to, which stands upright "
                                            "without 'lift'; write lift = 30 beside it");
    }
}

}  // namespace kushi
