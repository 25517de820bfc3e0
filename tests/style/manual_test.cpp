// SPDX-License-Identifier: Apache-2.0
#include "style/keys.h"
#include "style/quantity.h"
#include "style/spelling.h"

#include <kushi/head.h>
#include <kushi/style.h>

#include <fstream>
#include <sstream>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

namespace kushi {
namespace {

using testing::HasSubstr;

std::string manual() {
    std::ifstream file(KUSHI_SOURCE_DIR "/docs/style-file.md");
    std::ostringstream text;
    text << file.rdbuf();
    return text.str();
}

// From the heading that has `label` to the next heading.
std::string section(const std::string& text, std::string_view label) {
    std::istringstream lines(text);
    std::string found;
    bool inside = false;
    for (std::string line; std::getline(lines, line);) {
        if (line.starts_with('#')) inside = line.find(label) != std::string::npos;
        if (inside) found += line + '\n';
    }
    return found;
}

// The row of a table of keys.
std::string row(const std::string& text, std::string_view key) {
    std::istringstream lines(text);
    for (std::string line; std::getline(lines, line);) {
        const std::string cell = line.substr(0, line.find('|', 1));
        if (line.starts_with('|') && cell.find('`' + std::string(key) + '`') != std::string::npos) {
            return line;
        }
    }
    return {};
}

std::string labelOf(const TableKeys& table) {
    return &table == &tables::top ? "Top of the style" : '`' + std::string(table.label) + '`';
}

TEST(Manual, HasEveryKeyInTheSectionOfItsTable) {
    const std::string text = manual();
    for (const TableKeys* table : tables::all) {
        const std::string part = section(text, labelOf(*table));
        EXPECT_FALSE(part.empty()) << table->label;
        for (const std::string_view key : table->keys()) {
            EXPECT_FALSE(row(part, key).empty()) << table->label << ' ' << key;
        }
    }
}

TEST(Manual, HasTheRangesThatAreChecked) {
    const std::string text = manual();
    struct Checked {
        const TableKeys& table;
        std::string_view key;
        const Quantity& quantity;
    };
    const Checked checked[] = {
        {tables::top, "gravity", quantities::gravity},
        {tables::head, "unit", quantities::fileUnit},
        {tables::head, "offset", quantities::place},
        {tables::head, "gap", quantities::gap},
        {tables::head, "friction", quantities::friction},
        {tables::collider, "unit", quantities::fileUnit},
        {tables::collider, "offset", quantities::place},
        {tables::collider, "gap", quantities::gap},
        {tables::collider, "friction", quantities::friction},
        {tables::contact, "packing", quantities::packing},
        {tables::groom, "unit", quantities::fileUnit},
        {tables::groom, "offset", quantities::place},
        {tables::landmarks, "brows", quantities::place},
        {tables::scalp, "spacing", quantities::spacing},
        {tables::scalp, "jitter", quantities::jitter},
        {tables::scalp, "edge", quantities::edge},
        {tables::ellipsoid, "center", quantities::place},
        {tables::ellipsoid, "semi_axes", quantities::semiAxis},
        {tables::ellipsoid, "rotate_z", quantities::rotation},
        {tables::regions, "theta", quantities::theta},
        {tables::regions, "phi", quantities::phi},
        {tables::roots, "theta", quantities::theta},
        {tables::roots, "phi", quantities::phi},
        {tables::hair, "length", quantities::length},
        {tables::hair, "length_variation", quantities::lengthVariation},
        {tables::hair, "youngs_modulus", quantities::youngsModulus},
        {tables::hair, "diameter", quantities::diameter},
        {tables::hair, "density", quantities::density},
        {tables::hair, "flexural_rigidity", quantities::flexuralRigidity},
        {tables::hair, "stiffness", quantities::stiffness},
        {tables::solver, "grading", quantities::grading},
        {tables::hair, "shear_modulus", quantities::youngsModulus},
        {tables::hair, "taper", quantities::taper},
        {tables::hair, "lift", quantities::lift},
        {tables::whorl, "theta", quantities::theta},
        {tables::whorl, "phi", quantities::phi},
        {tables::whorl, "turn", quantities::turn},
        {tables::curl, "radius", quantities::curlSize},
        {tables::curl, "pitch", quantities::curlSize},
        {tables::curl, "variation", quantities::lengthVariation},
        {tables::wave, "amplitude", quantities::curlSize},
        {tables::wave, "length", quantities::curlSize},
        {tables::wave, "variation", quantities::lengthVariation},
        {tables::hair, "set", quantities::set},
        {tables::color, "melanin", quantities::melanin},
        {tables::color, "redness", quantities::redness},
        {tables::hair, "grey", quantities::colorShare},
        {tables::grey, "share", quantities::colorShare},
        {tables::regrowth, "length", quantities::coloredLength},
        {tables::regrowth, "blend", quantities::colorPlace},
        {tables::tips, "length", quantities::coloredLength},
        {tables::tips, "blend", quantities::colorPlace},
        {tables::highlight, "share", quantities::colorShare},
        {tables::highlight, "foil", quantities::foil},
        {tables::highlight, "from", quantities::colorPlace},
        {tables::highlight, "to", quantities::coloredLength},
        {tables::highlight, "blend", quantities::colorPlace},
        {tables::hair, "clump", quantities::clump},
        {tables::clump, "amount", quantities::clump},
        {tables::clump, "size", quantities::clumpSize},
        {tables::clump, "variation", quantities::variation},
        {tables::clump, "from", quantities::clumpFrom},
        {tables::hair, "flyaway", quantities::flyawayShare},
        {tables::flyaway, "share", quantities::flyawayShare},
        {tables::flyaway, "distance", quantities::flyawayDistance},
        {tables::hair, "color", quantities::color},
        {tables::hair, "variation", quantities::variation},
        {tables::force, "magnitude", quantities::magnitude},
        {tables::within, "x", quantities::place},
        {tables::within, "y", quantities::place},
        {tables::within, "z", quantities::place},
        {tables::falloff, "degrees", quantities::falloffAngle},
        {tables::falloff, "cm", quantities::falloffDistance},
        {tables::cut, "below", quantities::place},
        {tables::cut, "keep", quantities::place},
        {tables::cut, "keep", quantities::lengthLeft},
    };
    for (const auto& [table, key, quantity] : checked) {
        const std::string range = plainNumber(quantity.low) + " to " + plainNumber(quantity.high);
        EXPECT_THAT(row(section(text, labelOf(table)), key), HasSubstr(range));
    }
}

TEST(Manual, NamesEveryLandmarkAndZone) {
    const std::string heights = section(manual(), "Heights");
    for (const Landmark& landmark : headLandmarks()) {
        EXPECT_THAT(heights, HasSubstr("`\"" + std::string(landmark.name) + "\"`"));
        EXPECT_THAT(tables::landmarks.keys(), testing::Contains(landmark.name));
    }
    EXPECT_EQ(tables::landmarks.keys().size(), headLandmarks().size());
    const std::string zones = section(manual(), "Zones");
    for (const HairZone& zone : hairZones()) {
        EXPECT_THAT(zones, HasSubstr("`\"" + std::string(zone.name) + "\"`"));
    }
    EXPECT_THAT(zones, HasSubstr("`\"scalp\"`"));
}

TEST(Manual, HasExamplesThatAreStyles) {
    const std::string text = manual();
    const std::string fence = "```toml\n";
    int examples = 0;
    for (std::size_t at = text.find(fence); at != std::string::npos; at = text.find(fence, at)) {
        at += fence.size();
        const auto style = parseStyle(text.substr(at, text.find("```", at) - at), "style-file.md");
        EXPECT_TRUE(style) << toString(style.problems()[0]);
        ++examples;
    }
    EXPECT_EQ(examples, 10);
}

}  // namespace
}  // namespace kushi
