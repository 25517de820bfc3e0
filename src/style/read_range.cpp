// SPDX-License-Identifier: Apache-2.0
#include "style/read_number.h"
#include "style/read_parts.h"
#include "style/spelling.h"

#include <kushi/head.h>

#include <cmath>
#include <limits>

namespace kushi {

namespace {

/// What the ends of a range may be besides numbers.
enum class Ends {
    Plain,
    Place,   ///< infinite
    Height,  ///< infinite, or landmarks of the head
};

std::optional<double> readEnd(const Node& node, std::string_view name, const Quantity& quantity,
                              Ends ends, ReadContext& context) {
    if (ends != Ends::Plain && node.kind == Kind::Float && std::isinf(node.number())) {
        return node.number();
    }
    if (ends == Ends::Height) return readHeight(node, name, context.heights, context.problems);
    return readNumber(node, name, quantity, context.problems);
}

std::optional<Range> readRange(const Node& node, std::string_view name, const Quantity& quantity,
                               Ends ends, ReadContext& context) {
    if (node.kind != Kind::Array || node.items.size() != 2) {
        context.problems.unexpected(name, node, "a range, [low, high]");
        return std::nullopt;
    }
    const auto low = readEnd(node.items[0], name, quantity, ends, context);
    const auto high = readEnd(node.items[1], name, quantity, ends, context);
    if (!low || !high) return std::nullopt;
    if (*low >= *high) {
        context.problems.add(node.begin, std::string(name) + ": found a range from " +
                                             context.problems.source(node.items[0]) + " to " +
                                             context.problems.source(node.items[1]) +
                                             ", expected the lower end first");
        return std::nullopt;
    }
    return Range{*low, *high};
}

void readRangeAt(const TableReader& table, std::string_view key, const Quantity& quantity,
                 Ends ends, Range& out) {
    const Node* node = table.find(key);
    if (node != nullptr) {
        out = readRange(*node, key, quantity, ends, table.context()).value_or(out);
    }
}

// In the document's degrees, where a turn is exact.
void checkTurn(const TableReader& table) {
    const Node& phi = *table.find("phi");
    const double span = phi.items[1].number() - phi.items[0].number();
    if (span <= 360) return;
    table.context().problems.add(phi.begin, "phi: found a range that spans " + plainNumber(span) +
                                                " degrees, expected a turn of 360 at most");
}

RootRange readAngles(const TableReader& table) {
    RootRange range;
    readRangeAt(table, "theta", quantities::theta, Ends::Plain, range.theta);
    readRangeAt(table, "phi", quantities::phi, Ends::Plain, range.phi);
    if (std::isfinite(range.phi.low)) checkTurn(table);
    return range;
}

RootRanges toRootRanges(std::span<const AngleRange> zone) {
    RootRanges ranges;
    for (const AngleRange& range : zone) {
        ranges.push_back({{range.thetaLow, range.thetaHigh}, {range.phiLow, range.phiHigh}});
    }
    return ranges;
}

RootRanges readZone(const TableReader& table) {
    for (const char* angle : {"theta", "phi"}) {
        if (const Entry* entry = table.node().find(angle)) {
            table.context().problems.add(
                entry->at, "found '" + entry->key + "' beside 'where', expected one of them");
        }
    }
    std::vector<std::string_view> names = {"scalp"};
    for (const HairZone& zone : hairZones())
        names.push_back(zone.name);
    const auto chosen = table.chosenName("where", names);
    return toRootRanges(!chosen || *chosen == 0 ? hairRegion() : hairZones()[*chosen - 1].ranges);
}

}  // namespace

RootRanges readRootRanges(const Node& node, const TableKeys& kind, ReadContext& context) {
    const TableReader table(node, kind, context);
    return table.find("where") != nullptr ? readZone(table) : RootRanges{readAngles(table)};
}

Box readBox(const Node& node, ReadContext& context) {
    const TableReader table(node, tables::within, context);
    Box box;
    readRangeAt(table, "x", quantities::place, Ends::Place, box.x);
    readRangeAt(table, "y", quantities::place, Ends::Height, box.y);
    readRangeAt(table, "z", quantities::place, Ends::Place, box.z);
    return box;
}

}  // namespace kushi
