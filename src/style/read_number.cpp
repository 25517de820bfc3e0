// SPDX-License-Identifier: Apache-2.0
#include "style/read_number.h"

#include "style/spelling.h"

namespace kushi {

namespace {

bool holds(const Quantity& quantity, double value) {
    return value >= quantity.low && value <= quantity.high;
}

// What a number out of range would be, had it been meant in another unit.
std::string unitHint(const Quantity& quantity, double value, const std::string& spelled) {
    for (const Quantity::Mistaken& other : quantity.mistaken) {
        const double meant = value * other.size;
        if (other.unit.empty() || !holds(quantity, meant)) continue;
        return spelled + ' ' + std::string(other.unit) + " would be " + plainNumber(meant);
    }
    return {};
}

}  // namespace

std::string expectedNumber(const Quantity& quantity) {
    std::string text =
        "a number from " + plainNumber(quantity.low) + " to " + plainNumber(quantity.high);
    if (!quantity.unit.empty()) text += ' ' + std::string(quantity.unit);
    return text;
}

std::string stringHint(std::string_view text) {
    const bool looksNumeric =
        !text.empty() && std::string_view("+-.0123456789").find(text[0]) != std::string_view::npos;
    return looksNumeric ? "numbers stand without quotes and units" : "";
}

std::optional<double> readNumber(const Node& node, std::string_view name, const Quantity& quantity,
                                 Diagnostics& problems) {
    if (node.kind == Kind::String) {
        problems.unexpected(name, node, expectedNumber(quantity), stringHint(node.string()));
        return std::nullopt;
    }
    if (!node.isNumber()) {
        problems.unexpected(name, node, expectedNumber(quantity));
        return std::nullopt;
    }
    const double value = node.number();
    if (!holds(quantity, value)) {  // nor does it hold what is not a number
        problems.unexpected(name, node, expectedNumber(quantity),
                            unitHint(quantity, value, problems.source(node)));
        return std::nullopt;
    }
    return quantity.toSi(value);
}

std::optional<Vec3d> readVector(const Node& node, std::string_view name, const Quantity& quantity,
                                Diagnostics& problems) {
    if (node.kind != Kind::Array || node.items.size() != 3) {
        problems.unexpected(name, node, "an array of 3, each " + expectedNumber(quantity));
        return std::nullopt;
    }
    const auto x = readNumber(node.items[0], name, quantity, problems);
    const auto y = readNumber(node.items[1], name, quantity, problems);
    const auto z = readNumber(node.items[2], name, quantity, problems);
    if (!x || !y || !z) return std::nullopt;
    return Vec3d{*x, *y, *z};
}

}  // namespace kushi
