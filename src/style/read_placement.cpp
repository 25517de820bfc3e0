// SPDX-License-Identifier: Apache-2.0
#include "style/read_placement.h"

#include "style/read_number.h"

#include <algorithm>
#include <array>
#include <filesystem>

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

bool looksLikePath(const std::string& text) {
    return text.find_first_of("./\\") != std::string::npos;
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

bool readMeshPath(const TableReader& table, std::span<const std::string_view> names,
                  std::string& mesh) {
    const Node* node = table.find("mesh");
    if (node == nullptr || node->kind != Kind::String || !looksLikePath(node->string())) {
        if (const auto chosen = table.chosenName("mesh", names)) mesh = names[*chosen];
        return false;
    }
    if (isMeshPath(node->string())) {
        mesh = std::filesystem::path(table.context().folder) / node->string();
    } else {
        std::string expected;
        for (const std::string_view name : names)
            expected += '"' + std::string(name) + (name == names.back() ? "\" or " : "\", ");
        table.context().problems.unexpected(
            "mesh", *node, expected + "a file that ends in .obj, .ply, .stl, .gltf or .glb");
    }
    return true;
}

void readMeshPlacement(const TableReader& table, bool fromFile, MeshPlacement& placement) {
    readFileUnit(table, placement.unit);
    readAxes(table, placement.up, placement.front);
    table.choice<MeshOrigin>("origin", {{"crown", MeshOrigin::Crown}, {"file", MeshOrigin::File}},
                             placement.origin);
    table.vector("offset", quantities::place, placement.offset);
    for (const char* key : {"unit", "up", "front", "origin", "offset"}) {
        const Entry* entry = table.node().find(key);
        if (entry == nullptr || fromFile) continue;
        table.context().problems.add(
            entry->at, '\'' + entry->key + "' places a mesh from a file, and " + table.label() +
                           " names none, expected mesh = \"a path\" beside it");
    }
}

}  // namespace kushi
