// SPDX-License-Identifier: Apache-2.0
#include "style/read_parts.h"

#include <filesystem>

namespace kushi {

namespace {

constexpr int mostFollicles = 5'000'000;

Ellipsoid readEllipsoid(const Node& node, ReadContext& context) {
    const TableReader table(node, tables::ellipsoid, context);
    Ellipsoid ellipsoid;
    table.vector("center", quantities::place, ellipsoid.center);
    table.require("semi_axes", "the half widths in cm, as in [10.5, 12.5, 8.5]");
    table.vector("semi_axes", quantities::semiAxis, ellipsoid.semiAxes);
    table.number("rotate_z", quantities::rotation, ellipsoid.rotateZ);
    return ellipsoid;
}

// Either how densely or how many; what counts is what is written, whether it is right or not.
void readDensity(const TableReader& table, Scalp& scalp) {
    table.number("spacing", quantities::spacing, scalp.spacing);
    if (const auto count = table.whole("count", 1, mostFollicles)) {
        scalp.count = static_cast<int>(*count);
    }
    table.requireOne("spacing", "count", "spacing = 0.13");
}

void readGroups(const TableReader& table, const Node& node, std::vector<std::string>& groups) {
    const std::string expected = R"(an array of names, as in ["scalp"])";
    if (node.kind != Kind::Array || node.items.empty()) {
        table.context().problems.unexpected("groups", node, expected);
        return;
    }
    for (const Node& item : node.items) {
        if (item.kind == Kind::String && !item.string().empty()) {
            groups.push_back(item.string());
        } else {
            table.context().problems.unexpected("groups", item, "a name");
        }
    }
}

void readMask(const TableReader& table, const Node& node, std::optional<std::string>& mask) {
    if (node.kind == Kind::String &&
        (node.string().ends_with(".png") || node.string().ends_with(".PNG"))) {
        mask = std::filesystem::path(table.context().folder) / node.string();
    } else {
        table.context().problems.unexpected("mask", node, "a picture that ends in .png");
    }
}

// The surface that hair grows from, and what goes with a head's only.
void readSurface(const TableReader& table, Scalp& scalp) {
    ReadContext& context = table.context();
    table.choice<ScalpSurface>(
        "surface", {{"ellipsoid", ScalpSurface::Ellipsoid}, {"head", ScalpSurface::Head}},
        scalp.surface);
    const bool onHead = scalp.surface == ScalpSurface::Head;
    if (const Entry* surface = table.node().find("surface")) {
        scalp.surfacePlace = context.problems.place(surface->at);
        if (onHead && context.headless) {
            context.problems.add(surface->value.begin,
                                 "surface: hair is to grow from the head, but [head] has mesh = "
                                 "\"none\"");
        }
    }
    const auto place = [&](const Entry& entry) {
        if (!onHead) {
            context.problems.add(entry.at, '\'' + entry.key +
                                               "' is of a head's surface; write surface = "
                                               "\"head\" beside it");
        }
        return context.problems.place(entry.at);
    };
    if (const Entry* groups = table.node().find("groups")) {
        scalp.groupsPlace = place(*groups);
        readGroups(table, groups->value, scalp.groups);
    }
    if (const Entry* mask = table.node().find("mask")) {
        scalp.maskPlace = place(*mask);
        readMask(table, mask->value, scalp.mask);
    }
}

}  // namespace

Scalp readScalp(const Node& node, ReadContext& context) {
    const TableReader table(node, tables::scalp, context);
    Scalp scalp;
    table.require("ellipsoid", "a table, as in ellipsoid = { semi_axes = [10.5, 12.5, 8.5] }");
    if (const Node* ellipsoid = table.table("ellipsoid", tables::ellipsoid)) {
        scalp.ellipsoid = readEllipsoid(*ellipsoid, context);
    }
    readDensity(table, scalp);
    table.number("jitter", quantities::jitter, scalp.jitter);
    table.number("edge", quantities::edge, scalp.edge);
    readSurface(table, scalp);

    if (const Node* regions = table.find("regions")) {
        scalp.regions.clear();
        for (const Node* region : table.tables("regions", tables::regions)) {
            const RootRanges ranges = readRootRanges(*region, tables::regions, context);
            scalp.regions.insert(scalp.regions.end(), ranges.begin(), ranges.end());
        }
        if (regions->kind == Kind::Array && regions->items.empty()) {
            context.problems.unexpected("regions", *regions, "at least one table");
        }
    }
    return scalp;
}

}  // namespace kushi
