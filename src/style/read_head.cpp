// SPDX-License-Identifier: Apache-2.0
#include "style/read_number.h"
#include "style/read_parts.h"

#include <cmath>
#include <filesystem>

namespace kushi {

namespace {

bool looksLikePath(const std::string& text) {
    return text.find_first_of("./\\") != std::string::npos;
}

// Whether it is a file's.
bool readMeshKey(const TableReader& table, const std::string& folder, Style& style) {
    const Node* mesh = table.find("mesh");
    if (mesh == nullptr || mesh->kind != Kind::String || !looksLikePath(mesh->string())) {
        table.choice<std::string>("mesh", {{"mannequin", "mannequin"}, {"none", "none"}},
                                  style.headMesh);
        return false;
    }
    if (isMeshPath(mesh->string())) {
        style.headMesh = std::filesystem::path(folder) / mesh->string();
    } else {
        table.context().problems.unexpected(
            "mesh", *mesh,
            R"("mannequin", "none" or a file that ends in .obj, .ply, .stl, .gltf or .glb)");
    }
    return true;
}

void readUnit(const TableReader& table, std::optional<double>& unit) {
    const Node* node = table.find("unit");
    if (node != nullptr && node->isNumber()) {
        table.number("unit", quantities::meshUnit, unit);
    } else if (node != nullptr && node->kind != Kind::String) {
        table.context().problems.unexpected(
            "unit", *node, R"("m", "cm", "mm", "in" or )" + expectedNumber(quantities::meshUnit));
    } else {
        table.choice<std::optional<double>>(
            "unit", {{"m", 1}, {"cm", 0.01}, {"mm", 0.001}, {"in", 0.0254}}, unit);
    }
}

void readAxis(const TableReader& table, std::string_view key, Vec3d& axis) {
    table.choice<Vec3d>(key,
                        {{"x", {1, 0, 0}},
                         {"y", {0, 1, 0}},
                         {"z", {0, 0, 1}},
                         {"-x", {-1, 0, 0}},
                         {"-y", {0, -1, 0}},
                         {"-z", {0, 0, -1}}},
                        axis);
}

void readAxes(const TableReader& table, MeshPlacement& placement) {
    readAxis(table, "up", placement.up);
    readAxis(table, "front", placement.front);
    if (dot(placement.up, placement.front) == 0) return;
    const Node* given = table.find("up") != nullptr ? table.find("up") : table.find("front");
    table.context().problems.add(
        given->begin,
        "up and front lie along the same axis of the file (they are \"y\" and \"z\" "
        "where not given), expected two axes");
}

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

void readHead(const Node& node, const std::string& folder, ReadContext& context, Style& style) {
    const TableReader table(node, tables::head, context);
    const bool fromFile = readMeshKey(table, folder, style);
    MeshPlacement& placement = style.headPlacement;
    readUnit(table, placement.unit);
    readAxes(table, placement);
    table.choice<MeshOrigin>("origin", {{"crown", MeshOrigin::Crown}, {"file", MeshOrigin::File}},
                             placement.origin);
    table.vector("offset", quantities::place, placement.offset);
    readLandmarks(table);
    for (const char* key : {"unit", "up", "front", "origin", "offset"}) {
        const Entry* entry = node.find(key);
        if (entry == nullptr || fromFile) continue;
        context.problems.add(entry->at, '\'' + entry->key +
                                            "' places a mesh from a file, and [head] names none, "
                                            "expected mesh = \"a path\" beside it");
    }
}

}  // namespace kushi
