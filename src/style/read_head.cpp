// SPDX-License-Identifier: Apache-2.0
#include "style/read_parts.h"
#include "style/read_placement.h"

#include <filesystem>

namespace kushi {

namespace {

bool looksLikePath(const std::string& text) {
    return text.find_first_of("./\\") != std::string::npos;
}

// Whether it is a file's.
bool readMeshKey(const TableReader& table, Style& style) {
    const Node* mesh = table.find("mesh");
    if (mesh == nullptr || mesh->kind != Kind::String || !looksLikePath(mesh->string())) {
        table.choice<std::string>("mesh", {{"mannequin", "mannequin"}, {"none", "none"}},
                                  style.headMesh);
        return false;
    }
    if (isMeshPath(mesh->string())) {
        style.headMesh = std::filesystem::path(table.context().folder) / mesh->string();
    } else {
        table.context().problems.unexpected(
            "mesh", *mesh,
            R"("mannequin", "none" or a file that ends in .obj, .ply, .stl, .gltf or .glb)");
    }
    return true;
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

void readHead(const Node& node, ReadContext& context, Style& style) {
    const TableReader table(node, tables::head, context);
    const bool fromFile = readMeshKey(table, style);
    MeshPlacement& placement = style.headPlacement;
    readFileUnit(table, placement.unit);
    readAxes(table, placement.up, placement.front);
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
