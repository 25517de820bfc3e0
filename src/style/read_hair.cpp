// SPDX-License-Identifier: Apache-2.0
#include "style/read_parts.h"

namespace kushi {

Hair readHair(const Node& node, ReadContext& context) {
    const TableReader table(node, tables::hair, context);
    Hair hair;
    table.choice<double>("type", {{"fine", 60e-6}, {"medium", 75e-6}, {"coarse", 95e-6}},
                         hair.diameter);
    table.require("length", "a number of cm, as in length = 25");
    table.number("length", quantities::length, hair.length);
    table.number("length_variation", quantities::lengthVariation, hair.lengthVariation);
    table.number("youngs_modulus", quantities::youngsModulus, hair.youngsModulus);
    table.number("diameter", quantities::diameter, hair.diameter);
    table.number("density", quantities::density, hair.density);
    table.number("flexural_rigidity", quantities::flexuralRigidity, hair.flexuralRigidity);
    table.number("stiffness", quantities::stiffness, hair.stiffness);
    table.choice<Growth>("growth", {{"normal", Growth::Normal}, {"radial", Growth::Radial}},
                         hair.growth);
    return hair;
}

}  // namespace kushi
