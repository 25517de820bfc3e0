// SPDX-License-Identifier: Apache-2.0
#include "style/read_placement.h"

#include "style/read_number.h"

#include <algorithm>
#include <array>

namespace kushi {

namespace {

constexpr std::array<std::pair<std::string_view, Vec3d>, 6> axes = {{{"x", {1, 0, 0}},
                                                                     {"y", {0, 1, 0}},
                                                                     {"z", {0, 0, 1}},
                                                                     {"-x", {-1, 0, 0}},
                                                                     {"-y", {0, -1, 0}},
                                                                     {"-z", {0, 0, -1}}}};

void readAxis(const TableReader& table, std::string_view key, Vec3d& axis) {
    std::array<std::string_view, axes.size()> names;
    std::ranges::transform(axes, names.begin(), [](const auto& named) { return named.first; });
    if (const auto chosen = table.chosenName(key, names)) axis = axes[*chosen].second;
}

std::string quotedAxis(Vec3d axis) {
    for (const auto& [name, vector] : axes) {
        if (vector == axis) return '"' + std::string(name) + '"';
    }
    return {};
}

}  // namespace

void readFileUnit(const TableReader& table, std::optional<double>& unit) {
    const Node* node = table.find("unit");
    if (node != nullptr && node->isNumber()) {
        table.number("unit", quantities::fileUnit, unit);
    } else if (node != nullptr && node->kind != Kind::String) {
        table.context().problems.unexpected(
            "unit", *node, R"("m", "cm", "mm", "in" or )" + expectedNumber(quantities::fileUnit));
    } else {
        table.choice<std::optional<double>>(
            "unit", {{"m", 1}, {"cm", 0.01}, {"mm", 0.001}, {"in", 0.0254}}, unit);
    }
}

void readAxes(const TableReader& table, Vec3d& up, Vec3d& front) {
    const std::string defaults = quotedAxis(up) + " and " + quotedAxis(front);
    readAxis(table, "up", up);
    readAxis(table, "front", front);
    if (dot(up, front) == 0) return;
    const Node* given = table.find("up") != nullptr ? table.find("up") : table.find("front");
    table.context().problems.add(
        given->begin, "up and front lie along the same axis of the file (they are " + defaults +
                          " where not given), expected two axes");
}

}  // namespace kushi
