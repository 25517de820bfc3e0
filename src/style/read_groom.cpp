// SPDX-License-Identifier: Apache-2.0
#include "style/read_parts.h"
#include "style/read_placement.h"

#include <kushi/groom_io.h>

#include <filesystem>

namespace kushi {

namespace {

void readFile(std::string_view key, const Node& file, ReadContext& context, GroomSource& groom) {
    if (file.kind == Kind::String && isGroomPath(file.string())) {
        groom.path = std::filesystem::path(context.folder) / file.string();
    } else {
        context.problems.unexpected(key, file,
                                    "a file of strands that ends in .hair, .ply or .obj");
    }
}

}  // namespace

GroomSource readGroomSource(const Entry& entry, ReadContext& context) {
    GroomSource groom;
    groom.place = context.problems.place(entry.at);
    if (entry.value.kind != Kind::Table) {
        readFile("groom", entry.value, context, groom);
        return groom;
    }
    const TableReader table(entry.value, tables::groom, context);
    table.require("file", "the path of its strands, as in file = \"scan.hair\"");
    if (const Node* file = table.find("file")) readFile("file", *file, context, groom);
    readFileUnit(table, groom.placement.unit);
    readAxes(table, groom.placement.up, groom.placement.front);
    table.vector("offset", quantities::place, groom.placement.offset);
    return groom;
}

}  // namespace kushi
