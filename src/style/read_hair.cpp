// SPDX-License-Identifier: Apache-2.0
#include "style/read_number.h"
#include "style/read_parts.h"

#include <array>
#include <utility>

namespace kushi {

namespace {

// A natural shape: two sizes, both needed, and how much they vary.
template <class Shape>
void readShape(const TableReader& table, std::string_view key, const TableKeys& keys,
               const std::array<std::pair<std::string_view, double Shape::*>, 2>& sizes,
               std::optional<Shape>& out) {
    const Node* node = table.table(key, keys);
    if (node == nullptr) return;
    const TableReader reader(*node, keys, table.context());
    Shape shape;
    for (const auto& [name, size] : sizes) {
        reader.require(name, "a number of cm");
        reader.number(name, quantities::curlSize, shape.*size);
    }
    reader.number("variation", quantities::lengthVariation, shape.variation);
    out = shape;
}

void readNaturalShape(const TableReader& table, Hair& hair) {
    readShape<Curl>(table, "curl", tables::curl,
                    {{{"radius", &Curl::radius}, {"pitch", &Curl::pitch}}}, hair.curl);
    readShape<Wave>(table, "wave", tables::wave,
                    {{{"amplitude", &Wave::amplitude}, {"length", &Wave::length}}}, hair.wave);
    if (hair.curl && hair.wave) {
        table.context().problems.add(table.find("wave")->begin,
                                     "found 'wave' beside 'curl', expected one of them");
    }
}

void refuse(const Node& hair, std::string_view key, const std::string& why, Diagnostics& problems) {
    const Entry* entry = hair.find(key);
    if (entry != nullptr) problems.add(entry->at, '\'' + entry->key + "' " + why);
}

void refuseOther(const Node& hair, bool grows, Diagnostics& problems) {
    if (grows) {
        refuse(hair, "set",
               "is for the strands of a groom; hair that grows takes the shape of 'length', 'curl' "
               "and 'wave'",
               problems);
        return;
    }
    for (const std::string_view key :
         {"length", "length_variation", "growth", "curl", "wave", "lift", "towards", "whorl"})
        refuse(hair, key, "is for hair that grows; the strands of a groom are as its file has them",
               problems);
}

}  // namespace

Hair readHair(const Node& node, bool grows, ReadContext& context) {
    const TableReader table(node, tables::hair, context);
    Hair hair;
    table.choice<double>("type", {{"fine", 60e-6}, {"medium", 75e-6}, {"coarse", 95e-6}},
                         hair.diameter);
    if (grows) table.require("length", "a number of cm, as in length = 25");
    refuseOther(node, grows, context.problems);
    table.number("length", quantities::length, hair.length);
    table.number("length_variation", quantities::lengthVariation, hair.lengthVariation);
    table.number("youngs_modulus", quantities::youngsModulus, hair.youngsModulus);
    table.number("diameter", quantities::diameter, hair.diameter);
    table.number("density", quantities::density, hair.density);
    table.number("flexural_rigidity", quantities::flexuralRigidity, hair.flexuralRigidity);
    table.number("stiffness", quantities::stiffness, hair.stiffness);
    table.number("shear_modulus", quantities::youngsModulus, hair.shearModulus);
    table.number("taper", quantities::taper, hair.taper);
    readNaturalShape(table, hair);
    table.choice<Growth>("growth", {{"normal", Growth::Normal}, {"radial", Growth::Radial}},
                         hair.growth);
    readLean(table, hair);
    readColors(table, hair);
    table.number("set", quantities::set, hair.set);
    readDress(table, hair);
    return hair;
}

}  // namespace kushi
