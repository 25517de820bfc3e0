// SPDX-License-Identifier: Apache-2.0
#include "style/read_parts.h"

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
