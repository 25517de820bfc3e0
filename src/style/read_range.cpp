// SPDX-License-Identifier: Apache-2.0
#include "style/read_number.h"
#include "style/read_parts.h"
#include "style/spelling.h"

#include <cmath>
#include <limits>

namespace kushi {

namespace {

enum class Ends { Finite, MayBeInfinite };

std::optional<double> readEnd(const Node& node, std::string_view name, const Quantity& quantity,
                              Ends ends, ReadContext& context) {
    if (ends == Ends::MayBeInfinite && node.kind == Kind::Float && std::isinf(node.number())) {
        return node.number();
    }
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

}  // namespace

RootRange readRootRange(const Node& node, const TableKeys& kind, ReadContext& context) {
    const TableReader table(node, kind, context);
    RootRange range;
    readRangeAt(table, "theta", quantities::theta, Ends::Finite, range.theta);
    readRangeAt(table, "phi", quantities::phi, Ends::Finite, range.phi);
    if (std::isfinite(range.phi.low)) checkTurn(table);
    return range;
}

Box readBox(const Node& node, ReadContext& context) {
    const TableReader table(node, tables::within, context);
    Box box;
    readRangeAt(table, "x", quantities::place, Ends::MayBeInfinite, box.x);
    readRangeAt(table, "y", quantities::place, Ends::MayBeInfinite, box.y);
    readRangeAt(table, "z", quantities::place, Ends::MayBeInfinite, box.z);
    return box;
}

}  // namespace kushi
