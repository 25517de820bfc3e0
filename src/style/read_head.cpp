// SPDX-License-Identifier: Apache-2.0
#include "style/read_parts.h"
#include "style/read_placement.h"

#include <array>

namespace kushi {

namespace {

void readLandmarks(const TableReader& head) {
    const Node* node = head.table("landmarks", tables::landmarks);
    if (node == nullptr) return;
    ReadContext& context = head.context();
    const TableReader table(*node, tables::landmarks, context);
    for (const std::string_view name : tables::landmarks.keys()) {
        std::optional<double> height;
        table.number(name, quantities::place, height);
        if (height) context.heights.set(name, *height);
    }
}

}  // namespace

void readHead(const Node& node, ReadContext& context, Style& style) {
    const TableReader table(node, tables::head, context);
    constexpr std::array<std::string_view, 2> names = {"mannequin", "none"};
    const bool fromFile = readMeshPath(table, names, style.headMesh);
    readMeshPlacement(table, fromFile, style.headPlacement);
    readLandmarks(table);
    table.boolean("collide", style.headCollides);
    table.number("gap", quantities::gap, style.headGap);
    table.number("friction", quantities::friction, style.headFriction);
}

}  // namespace kushi
