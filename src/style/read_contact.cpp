// SPDX-License-Identifier: Apache-2.0
#include "style/read_parts.h"
#include "style/read_placement.h"

#include <array>

namespace kushi {

Collider readCollider(const Node& node, ReadContext& context) {
    const TableReader table(node, tables::collider, context);
    Collider collider;
    collider.placement.origin = MeshOrigin::File;
    collider.placement.leastHeight = 0.001;
    table.require("mesh", "the path of what hair keeps out of, as in mesh = \"body.glb\"");
    constexpr std::array<std::string_view, 1> names = {"mannequin"};
    const bool fromFile = readMeshPath(table, names, collider.mesh);
    readMeshPlacement(table, fromFile || !table.has("mesh"), collider.placement);
    table.number("gap", quantities::gap, collider.gap);
    table.number("friction", quantities::friction, collider.friction);
    return collider;
}

Contact readContact(const Node& node, ReadContext& context) {
    const TableReader table(node, tables::contact, context);
    Contact contact;
    table.boolean("layers", contact.layers);
    table.number("packing", quantities::packing, contact.packing);
    return contact;
}

}  // namespace kushi
