// SPDX-License-Identifier: Apache-2.0
#include "style/read_direction.h"

#include "style/read_number.h"

#include <algorithm>
#include <cmath>

namespace kushi {

namespace {

struct NamedDirection {
    bool radial = false;
    Vec3d vector;
    bool reversed = false;
};

void readName(const TableReader& table, std::string_view key, ForceDirection& direction,
              bool& reversed) {
    const NamedDirection out = {true, {}, false};
    const NamedDirection in = {true, {}, true};
    NamedDirection named;
    table.choice<NamedDirection>(key,
                                 {{"x", {false, {1, 0, 0}}},
                                  {"y", {false, {0, 1, 0}}},
                                  {"z", {false, {0, 0, 1}}},
                                  {"r", out},
                                  {"front", {false, {1, 0, 0}}},
                                  {"back", {false, {-1, 0, 0}}},
                                  {"left", {false, {0, 0, -1}}},
                                  {"right", {false, {0, 0, 1}}},
                                  {"up", {false, {0, 1, 0}}},
                                  {"down", {false, {0, -1, 0}}},
                                  {"out", out},
                                  {"in", in}},
                                 named);
    direction = {named.radial, named.vector};
    reversed = named.reversed;
}

void readNumbers(const TableReader& table, std::string_view key, const Node& node,
                 ForceDirection& direction) {
    const auto vector = readVector(node, key, quantities::direction, table.context().problems);
    if (!vector) return;
    const double largest =
        std::max({std::abs(vector->x), std::abs(vector->y), std::abs(vector->z)});
    if (largest == 0) {
        table.context().problems.add(
            node.begin,
            std::string(key) + ": found a zero vector, expected one that points somewhere");
        return;
    }
    // Scaled first, so that the squares of tiny components do not vanish.
    direction = {false, normalized(*vector / largest)};
}

}  // namespace

void readDirection(const TableReader& table, std::string_view key, ForceDirection& direction,
                   bool& reversed) {
    const Node* node = table.find(key);
    if (node == nullptr) return;
    if (node->kind == Kind::String) {
        readName(table, key, direction, reversed);
    } else if (node->kind == Kind::Array) {
        readNumbers(table, key, *node, direction);
    } else {
        table.context().problems.unexpected(key, *node, expectedDirection);
    }
}

}  // namespace kushi
