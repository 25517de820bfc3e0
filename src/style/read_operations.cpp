// SPDX-License-Identifier: Apache-2.0
#include "style/read_direction.h"
#include "style/read_number.h"
#include "style/read_parts.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace kushi {

namespace {

void readFalloffOf(const TableReader& operation, Falloff& out) {
    const Node* node = operation.table("falloff", tables::falloff);
    if (node == nullptr) return;
    const TableReader table(*node, tables::falloff, operation.context());
    table.number("degrees", quantities::falloffAngle, out.angle);
    table.number("cm", quantities::falloffDistance, out.distance);
}

void readRoots(const TableReader& table, RootRanges& out) {
    if (const Node* roots = table.table("roots", tables::roots)) {
        out = readRootRanges(*roots, tables::roots, table.context());
    }
}

// `last` is the height of the pair before, in m.
std::optional<Cut::Keep> readPair(const Node& node, double last, ReadContext& context) {
    if (node.kind != Kind::Array || node.items.size() != 2) {
        context.problems.unexpected("keep", node,
                                    "a pair of cm, [height of the root, length left]");
        return std::nullopt;
    }
    const auto y = readHeight(node.items[0], "keep", context.heights, context.problems);
    const auto length = readNumber(node.items[1], "keep", quantities::lengthLeft, context.problems);
    if (!y || !length) return std::nullopt;
    if (*y <= last) {
        context.problems.unexpected("keep", node.items[0], "heights in ascending order");
    }
    return Cut::Keep{*y, *length};
}

std::vector<Cut::Keep> readKeep(const Node& node, ReadContext& context) {
    std::vector<Cut::Keep> keep;
    if (node.kind != Kind::Array || node.items.empty()) {
        context.problems.unexpected(
            "keep", node, "pairs of a root's height and the length left, as in [[-4, 2], [8, 6]]");
        return keep;
    }
    double last = -std::numeric_limits<double>::infinity();
    for (const Node& item : node.items) {
        const auto pair = readPair(item, last, context);
        if (!pair) continue;
        keep.push_back(*pair);
        last = pair->y;
    }
    return keep;
}

void readExtent(const TableReader& table, Cut& cut) {
    if (const Node* below = table.find("below")) {
        const ReadContext& context = table.context();
        cut.below = readHeight(*below, "below", context.heights, context.problems);
    }
    if (const Node* keep = table.find("keep")) cut.keep = readKeep(*keep, table.context());
    table.requireOne("below", "keep", "below = 3.5");
}

}  // namespace

Force readForce(const Node& node, ReadContext& context) {
    const TableReader table(node, tables::force, context);
    Force force;
    readRoots(table, force.roots);
    if (const Node* within = table.table("within", tables::within)) {
        force.within = readBox(*within, context);
    }
    table.number("magnitude", quantities::magnitude, force.magnitude);
    table.require("direction", expectedDirection);
    bool reversed = false;
    readDirection(table, "direction", force.direction, reversed);
    if (reversed) force.magnitude = -force.magnitude;
    readFalloffOf(table, force.falloff);
    return force;
}

Cut readCut(const Node& node, ReadContext& context) {
    const TableReader table(node, tables::cut, context);
    Cut cut;
    readRoots(table, cut.roots);
    readExtent(table, cut);
    table.choice<CutMode>("mode", {{"hide", CutMode::Hide}, {"settle", CutMode::Settle}}, cut.mode);
    readFalloffOf(table, cut.falloff);
    return cut;
}

HairTie readTie(const Node& node, ReadContext& context) {
    const TableReader table(node, tables::tie, context);
    HairTie tie;
    tie.at.x = std::numeric_limits<double>::quiet_NaN();
    readRoots(table, tie.roots);
    table.require("at", "at = [-11, 4, 0]");
    table.vector("at", quantities::place, tie.at);
    table.number("radius", quantities::tieRadius, tie.radius);
    table.number("slack", quantities::slack, tie.slack);
    return tie;
}

}  // namespace kushi
