// SPDX-License-Identifier: Apache-2.0
#include "style/number_or_table.h"
#include "style/read_parts.h"

#include <kushi/pigment.h>

#include <algorithm>

namespace kushi {

namespace {

// At which pigment stands for a colour, and colours for pigment.
constexpr double usualRoughness = 0.3;

// Linear light, of a whole head of hair; docs/style-file.md lists about what they are in sRGB.
void readNamedColor(const TableReader& table, Rgb& color) {
    table.choice<Rgb>("color",
                      {{"black", {0.01F, 0.008F, 0.007F}},
                       {"dark brown", {0.06F, 0.032F, 0.02F}},
                       {"brown", {0.12F, 0.065F, 0.036F}},
                       {"light brown", {0.22F, 0.13F, 0.072F}},
                       {"auburn", {0.10F, 0.03F, 0.014F}},
                       {"red", {0.26F, 0.075F, 0.024F}},
                       {"dark blond", {0.32F, 0.21F, 0.11F}},
                       {"blond", {0.45F, 0.30F, 0.15F}},
                       {"platinum", {0.68F, 0.58F, 0.42F}},
                       {"grey", {0.30F, 0.29F, 0.28F}},
                       {"white", {0.72F, 0.71F, 0.68F}}},
                      color);
}

Rgb readMelanin(const Node& node, ReadContext& context) {
    const TableReader table(node, tables::color, context);
    double melanin = 0;
    double redness = 0;
    table.require("melanin", "a number from 0 to 20, as in melanin = 1.3");
    table.number("melanin", quantities::melanin, melanin);
    table.number("redness", quantities::redness, redness);
    return colorOfAbsorption(
        absorptionOfMelanin(static_cast<float>(melanin), static_cast<float>(redness)),
        usualRoughness);
}

void readEnd(const TableReader& hair, std::string_view key, const TableKeys& keys,
             double blendShare, std::optional<EndColor>& out) {
    const Node* node = hair.table(key, keys);
    if (node == nullptr) return;
    const TableReader table(*node, keys, hair.context());
    EndColor end;
    table.require("color", "a colour, as in color = \"blond\"");
    readColor(table, end.color);
    table.require("length", "a number of cm, as in length = 3");
    table.number("length", quantities::coloredLength, end.length);
    end.blend = blendShare * end.length;
    table.number("blend", quantities::colorPlace, end.blend);
    if (end.length > 0 && end.blend > end.length) {
        table.context().problems.unexpected("blend", *table.find("blend"),
                                            "no more than the 'length'");
    }
    out = end;
}

void readGrey(const TableReader& hair, Grey& grey) {
    readNumberOrTable(hair, "grey", quantities::colorShare, "{ share = 0.3, color = \"white\" }",
                      grey.share, [&](const Node& node) {
                          const TableReader table(node, tables::grey, hair.context());
                          table.require("share", expectedNumber(quantities::colorShare));
                          table.number("share", quantities::colorShare, grey.share);
                          readColor(table, grey.color);
                      });
}

}  // namespace

void readColor(const TableReader& table, Rgb& color) {
    const Node* node = table.find("color");
    if (node == nullptr) return;
    Diagnostics& problems = table.context().problems;
    if (node->kind == Kind::String) {
        readNamedColor(table, color);
    } else if (node->kind == Kind::Array) {
        const auto rgb = readVector(*node, "color", quantities::color, problems);
        if (!rgb) return;
        const Vec3f linear = rgb->as<float>();
        color = {linear.x, linear.y, linear.z};
    } else if (node->kind == Kind::Table) {
        color = readMelanin(*node, table.context());
    } else {
        problems.unexpected("color", *node,
                            "a name as in \"brown\", sRGB components as in [0.5, 0.35, 0.25] or "
                            "pigment as in { melanin = 1.3 }");
    }
}

void readColors(const TableReader& table, Hair& hair) {
    readColor(table, hair.color);
    table.number("variation", quantities::variation, hair.variation);
    readGrey(table, hair.grey);
    readEnd(table, "regrowth", tables::regrowth, 1.0 / 3, hair.regrowth);
    readEnd(table, "tips", tables::tips, 1, hair.tips);
}

Highlight readHighlight(const Node& node, ReadContext& context) {
    const TableReader table(node, tables::highlight, context);
    Highlight highlight;
    if (const Node* roots = table.table("roots", tables::roots))
        highlight.roots = readRootRanges(*roots, tables::roots, context);
    table.require("color", "a colour, as in color = \"blond\"");
    readColor(table, highlight.color);
    table.number("share", quantities::colorShare, highlight.share);
    table.number("foil", quantities::foil, highlight.foil);
    table.number("from", quantities::colorPlace, highlight.from);
    table.number("to", quantities::coloredLength, highlight.to);
    table.number("blend", quantities::colorPlace, highlight.blend);
    if (highlight.to <= highlight.from) {
        context.problems.unexpected("to", *table.find("to"), "more than 'from'");
    }
    return highlight;
}

}  // namespace kushi
